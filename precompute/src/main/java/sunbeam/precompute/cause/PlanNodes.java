package sunbeam.precompute.cause;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SmoothCieWeights;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.BandRule;
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
    private static final double[] GAUSS_PLACES = {
        0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263
    };
    private static final double[] GAUSS_WEIGHTS = {
        0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269
    };
    private static final double PER_METRE = 8e9;

    private final CieTable cie;
    private final double[][] smooth = new double[3][];
    private final double[] white;
    private final double norm;

    PlanNodes(CieTable cie) {
        this.cie = cie;
        for (int c = 0; c < 3; c++) {
            smooth[c] = SmoothCieWeights.of(cie, c);
        }
        white = ColorArrays.cieWhite(cie);
        norm = 1 / cie.integralOfY();
    }

    /** Whether the colour tables have their corners at whole nanometres. */
    enum Weights {
        SMOOTH,
        TABLE
    }

    /** A place of 1 / lambda, and the length that it stands for. */
    record WaveNumber(double value, double length) {}

    /** Step i, from first to last, lies at 1 / lambda = origin + i size. */
    static List<WaveNumber> steps(double origin, double size, long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(i -> new WaveNumber(origin + size * i, size))
                .toList();
    }

    /** Gauss's rule on panels that are graded at both ends. */
    static List<WaveNumber> panels(double low, double high, double largest) {
        int equal = (int) Math.max(Math.ceil((high - low) / largest - 1e-3), 2);
        double size = (high - low) / equal;
        List<Double> edges = new ArrayList<>(List.of(0.0, 0.25, 0.5));
        for (int i = 1; i < equal; i++) {
            edges.add((double) i);
        }
        edges.addAll(List.of(equal - 0.5, equal - 0.25, (double) equal));
        List<WaveNumber> places = new ArrayList<>();
        for (int panel = 0; panel + 1 < edges.size(); panel++) {
            double width = edges.get(panel + 1) - edges.get(panel);
            for (int i = 0; i < GAUSS_PLACES.length; i++) {
                places.add(new WaveNumber(
                        low + size * (edges.get(panel) + width * GAUSS_PLACES[i]), size * width * GAUSS_WEIGHTS[i]));
            }
        }
        return places;
    }

    /** The whole band, which may cut power anywhere. */
    static List<WaveNumber> cutBand(BandRule rule, DirectionPair pair) {
        double uv = Math.hypot(pair.u(), pair.v());
        if (uv > rule.reach()) {
            return panels(LOWEST, HIGHEST, Math.min(rule.largestPanel(), rule.panel() / uv));
        }
        int last = rule.fewestNodes() - 1;
        return cut(steps(LOWEST, (HIGHEST - LOWEST) / last, 0, last), 0, 0);
    }

    /** Corrected at both ends, which lie so many steps beyond the first and the last. */
    private static List<WaveNumber> cut(List<WaveNumber> steps, double beyondFirst, double beyondLast) {
        List<WaveNumber> places = new ArrayList<>(steps);
        double[] low = endWeights(beyondFirst);
        double[] high = endWeights(beyondLast);
        for (int i = 0; i < low.length; i++) {
            scale(places, i, low[i]);
            scale(places, places.size() - 1 - i, high[i]);
        }
        return places;
    }

    private static void scale(List<WaveNumber> places, int at, double factor) {
        places.set(
                at,
                new WaveNumber(places.get(at).value(), factor * places.get(at).length()));
    }

    /** Exact for cubics whose integral ends t steps beyond. */
    private static double[] endWeights(double t) {
        double first = 1.0 / 12 - t * t / 2;
        double second = -first / 2 + t * t * t / 6;
        double third = first / 3 - t * t * t / 6 - 1.0 / 720 - Math.pow(t, 4) / 24;
        return new double[] {
            0.5 + t - first + second - third, 1 + first - 2 * second + 3 * third, 1 + second - 3 * third, 1 + third
        };
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
            return band(cutBand(rays.band(), pair), new PlanNode.Anywhere());
        }
        return sampling instanceof OrderSampling orders
                ? new OrderNodes(this, orders, model, pair).all()
                : onGrid((GridSampling) sampling, pair);
    }

    private List<PlanNode> onGrid(GridSampling grid, DirectionPair pair) {
        boolean alongX = Math.abs(pair.u()) >= Math.abs(pair.v());
        double major = Math.abs(alongX ? pair.u() : pair.v());
        if (major < grid.centreReach()) {
            return band(cutBand(grid.band(), pair), new PlanNode.Anywhere());
        }
        double crossed = major / grid.nodeStep() * (HIGHEST - LOWEST);
        int stride = grid.stride(major / Math.hypot(pair.u(), pair.v()), crossed);
        double size = grid.nodeStep() * stride / major;
        long first = (long) Math.ceil(LOWEST / size);
        long last = (long) Math.floor(HIGHEST / size);
        List<WaveNumber> steps = steps(0, size, first, last);
        return band(
                grid.endsCut() ? cut(steps, first - LOWEST / size, HIGHEST / size - last) : steps,
                new PlanNode.OnLine(alongX));
    }

    /** Over the whole band: constant power comes out exactly. */
    List<PlanNode> band(List<WaveNumber> places, PlanNode.Place place) {
        List<PlanNode> nodes = part(places, place, Weights.SMOOTH);
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

    /** Over what the places cover. */
    List<PlanNode> part(List<WaveNumber> places, PlanNode.Place place, Weights weights) {
        List<PlanNode> nodes = new ArrayList<>();
        for (WaveNumber at : places) {
            double wavelength = 1 / at.value();
            double[] xyz = new double[3];
            for (int c = 0; c < 3; c++) {
                double weight = weights == Weights.TABLE ? cie.at(wavelength, c) : smooth(wavelength, c);
                xyz[c] = at.length() * norm * weight * wavelength * wavelength;
            }
            nodes.add(new PlanNode(wavelength, xyz, place));
        }
        return nodes;
    }

    private double smooth(double wavelength, int channel) {
        double position = Math.max(
                0, Math.min(SmoothCieWeights.SAMPLES - 1.0, (wavelength - CieTable.MINIMUM_WAVELENGTH) * PER_METRE));
        int left = (int) Math.min(SmoothCieWeights.SAMPLES - 2.0, position);
        double fraction = position - left;
        return smooth[channel][left] * (1 - fraction) + smooth[channel][left + 1] * fraction;
    }
}
