package sunbeam.precompute.cause;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SmoothCieWeights;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.OrderSampling;

/** The wavelengths around each order that a direction sees (shaders/method/full_orders.glsl). */
final class OrderNodes {
    private static final double LONGEST = CieTable.MAXIMUM_WAVELENGTH;
    private static final double SHORTEST = CieTable.MINIMUM_WAVELENGTH;
    // As in the shader.
    private static final double FLANK_REACH = 6.5;
    private static final double SPECULAR_REACH = 5;

    private final PlanNodes weights;
    private final OrderSampling orders;
    private final DirectionPair pair;
    private final double u;
    private final double v;
    private final double sigma;
    private final double periodX;
    private final double periodY;

    OrderNodes(PlanNodes weights, OrderSampling orders, PlanModel model, DirectionPair pair) {
        this.weights = weights;
        this.orders = orders;
        this.pair = pair;
        this.u = pair.u();
        this.v = pair.v();
        this.sigma = model.sigmaFrequency();
        this.periodX = model.map().width();
        this.periodY = model.map().height();
    }

    List<PlanNode> all() {
        if (Math.hypot(u, v) < SPECULAR_REACH * sigma * LONGEST) {
            return weights.band(PlanNodes.cutBand(orders.band(), pair), new PlanNode.Anywhere());
        }
        boolean alongX = Math.abs(u * periodX) >= Math.abs(v * periodY);
        double major = alongX ? u * periodX : v * periodY;
        double minor = alongX ? v * periodY : u * periodX;
        double reach = FLANK_REACH * sigma * Math.max(periodX, periodY);
        int first = (int) Math.max(1, Math.ceil(Math.abs(major) / LONGEST - reach));
        int last = (int) Math.floor(Math.abs(major) / SHORTEST + reach);
        List<PlanNode> nodes = new ArrayList<>();
        for (int m = first; m <= last; m++) {
            int majorBin = (int) (m * Math.signum(major));
            int minorBin = (int) Math.floor(majorBin * minor / major + 0.5);
            nodes.addAll(alongX ? one(majorBin, minorBin) : one(minorBin, majorBin));
        }
        return nodes;
    }

    private List<PlanNode> one(int binX, int binY) {
        double fx = binX / periodX;
        double fy = binY / periodY;
        double squared = u * u + v * v;
        double middle = (fx * u + fy * v) / squared;
        double distance = (fx * v - fy * u) / Math.sqrt(squared);
        double deviation = sigma / Math.sqrt(2 * squared);
        boolean inside = middle * LONGEST > 1.03 && middle * SHORTEST < 0.97;
        double half = (inside ? orders.reach() : FLANK_REACH) * deviation;
        double low = Math.max(middle - half, 1 / LONGEST);
        double high = Math.min(middle + half, 1 / SHORTEST);
        if (high <= low || Math.abs(distance) > FLANK_REACH * sigma) {
            return List.of();
        }
        PlanNode.OneOrder order = new PlanNode.OneOrder(binX, binY);
        double largestStep =
                Math.min(orders.largestStep() * middle * middle, middle * Math.sqrt(orders.cornerLength() * deviation));
        double flank = Math.max(0, Math.max(low - middle, middle - high)) / deviation;
        double seen = deviation / (1 + flank);
        PlanNodes.Weights kind = seen < SmoothCieWeights.NARROW_ORDER * middle * middle
                ? PlanNodes.Weights.TABLE
                : PlanNodes.Weights.SMOOTH;
        if (low > middle - half || high < middle + half) {
            double largest = Math.min(orders.panel() * seen, 3 * largestStep);
            return weights.part(PlanNodes.panels(low, high, largest), order, kind);
        }
        double spacing = Math.min(orders.nodeSpacing() * deviation, largestStep);
        int intervals = Math.max((int) Math.ceil((high - low) / spacing), 2);
        return weights.part(PlanNodes.steps(low, (high - low) / intervals, 0, intervals), order, kind);
    }
}
