package sunbeam.precompute.cause;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SmoothCieWeights;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.BinSampling;
import sunbeam.precompute.plan.GridSampling;
import sunbeam.precompute.plan.OrderSampling;
import sunbeam.precompute.plan.RaySampling;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.shader.ColorArrays;

/** The wavelengths of a plan's shaders, with their weights, in double precision (shaders/include/integral.glsl). */
final class PlanNodes {
    private static final double LOWEST = 1 / CieTable.MAXIMUM_WAVELENGTH;
    private static final double HIGHEST = 1 / CieTable.MINIMUM_WAVELENGTH;
    private static final double[] CUT_END = {3.0 / 8, 7.0 / 6, 23.0 / 24};
    private static final double PER_METRE = 8e9;

    private final double[][] weights = new double[3][];
    private final double[] white;
    private final double norm;

    PlanNodes(CieTable cie) {
        for (int c = 0; c < 3; c++) {
            weights[c] = SmoothCieWeights.of(cie, c);
        }
        white = ColorArrays.cieWhite(cie);
        norm = 1 / cie.integralOfY();
    }

    /** Step i, from first to last, lies at 1 / lambda = origin + i size. */
    record Steps(double origin, double size, long first, long last, boolean cutFirst, boolean cutLast) {
        static Steps cutBand(int count) {
            return new Steps(LOWEST, (HIGHEST - LOWEST) / (count - 1), 0, count - 1, true, true);
        }

        private double endWeight(long i) {
            double low = cutFirst && i - first < CUT_END.length ? CUT_END[(int) (i - first)] : 1;
            double high = cutLast && last - i < CUT_END.length ? CUT_END[(int) (last - i)] : 1;
            return low * high;
        }
    }

    /** All that a direction takes. */
    List<PlanNode> of(Sampling sampling, PlanModel model, DirectionPair pair) {
        if (sampling instanceof BinSampling bins) {
            List<PlanNode> nodes = new ArrayList<>();
            for (int i = 0; i < bins.wavelengths().count(); i++) {
                nodes.add(new PlanNode(
                        bins.wavelengths().wavelengths()[i], bins.wavelengths().weights()[i], new PlanNode.Anywhere()));
            }
            return nodes;
        }
        if (sampling instanceof RaySampling rays) {
            double length = Math.hypot(pair.u(), pair.v());
            int along = (int) Math.ceil(length * (HIGHEST - LOWEST) / rays.nodeStep()) + 1;
            return band(Steps.cutBand(Math.max(rays.fewestNodes(), along)), new PlanNode.Anywhere());
        }
        return sampling instanceof OrderSampling orders
                ? new OrderNodes(this, orders, model, pair).all()
                : onGrid((GridSampling) sampling, pair);
    }

    private List<PlanNode> onGrid(GridSampling grid, DirectionPair pair) {
        boolean alongX = Math.abs(pair.u()) >= Math.abs(pair.v());
        double major = Math.abs(alongX ? pair.u() : pair.v());
        if (major < grid.centreReach()) {
            return band(Steps.cutBand(grid.fewestNodes()), new PlanNode.Anywhere());
        }
        double crossed = major / grid.nodeStep() * (HIGHEST - LOWEST);
        int stride = (int) Math.max(1, Math.min(grid.largestStride(), Math.floor(crossed) / grid.fewestNodes()));
        double size = grid.nodeStep() * stride / major;
        Steps steps =
                new Steps(0, size, (long) Math.ceil(LOWEST / size), (long) Math.floor(HIGHEST / size), false, false);
        return band(steps, new PlanNode.OnLine(alongX));
    }

    /** Over the whole band: constant power comes out exactly. */
    List<PlanNode> band(Steps steps, PlanNode.Place place) {
        List<PlanNode> nodes = part(steps, place);
        double[] one = new double[3];
        nodes.forEach(node -> {
            for (int c = 0; c < 3; c++) {
                one[c] += node.weights()[c];
            }
        });
        nodes.forEach(node -> {
            for (int c = 0; c < 3; c++) {
                node.weights()[c] *= white[c] / one[c];
            }
        });
        return nodes;
    }

    /** Over what the steps cover. */
    List<PlanNode> part(Steps steps, PlanNode.Place place) {
        List<PlanNode> nodes = new ArrayList<>();
        for (long i = steps.first(); i <= steps.last(); i++) {
            double wavelength = 1 / (steps.origin() + steps.size() * i);
            double[] xyz = new double[3];
            for (int c = 0; c < 3; c++) {
                xyz[c] = steps.size() * steps.endWeight(i) * weight(wavelength, c) * wavelength * wavelength;
            }
            nodes.add(new PlanNode(wavelength, xyz, place));
        }
        return nodes;
    }

    private double weight(double wavelength, int channel) {
        double position = Math.max(
                0, Math.min(SmoothCieWeights.SAMPLES - 1.0, (wavelength - CieTable.MINIMUM_WAVELENGTH) * PER_METRE));
        int left = (int) Math.min(SmoothCieWeights.SAMPLES - 2.0, position);
        double fraction = position - left;
        return norm * (weights[channel][left] * (1 - fraction) + weights[channel][left + 1] * fraction);
    }
}
