package sunbeam.precompute.plan;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.text.Text;

/**
 * Intervals of u, v and |w| (0..2) that a scene can reach; nothing outside is computed or stored. If it has one light, for every direction
 * to the viewer, w follows from u and v; if it has pairs of directions, there are no others.
 */
public record VisibleRange(
        double minimumU,
        double maximumU,
        double minimumV,
        double maximumV,
        double minimumW,
        double maximumW,
        Optional<Direction> light,
        List<DirectionPair> pairs) {
    public VisibleRange(
            double minimumU, double maximumU, double minimumV, double maximumV, double minimumW, double maximumW) {
        this(minimumU, maximumU, minimumV, maximumV, minimumW, maximumW, Optional.empty(), List.of());
    }

    public static VisibleRange all() {
        return new VisibleRange(-2, 2, -2, 2, 0, 2);
    }

    /** Returns the range of a BRDF map: one light, every direction to the viewer. */
    public static VisibleRange of(Direction light) {
        return new VisibleRange(
                -light.x() - 1,
                -light.x() + 1,
                -light.y() - 1,
                -light.y() + 1,
                light.z(),
                light.z() + 1,
                Optional.of(light),
                List.of());
    }

    /** Returns the smallest range that holds these pairs of directions, at least one. */
    public static VisibleRange of(List<DirectionPair> pairs) {
        DoubleSummaryStatistics u = pairs.stream().mapToDouble(DirectionPair::u).summaryStatistics();
        DoubleSummaryStatistics v = pairs.stream().mapToDouble(DirectionPair::v).summaryStatistics();
        DoubleSummaryStatistics w =
                pairs.stream().mapToDouble(pair -> -pair.w()).summaryStatistics();
        return new VisibleRange(
                u.getMin(), u.getMax(), v.getMin(), v.getMax(), w.getMin(), w.getMax(), Optional.empty(), pairs);
    }

    /** Returns the range with a margin in u and v, and other limits of |w|. */
    public VisibleRange with(double margin, double leastW, double largestW) {
        return new VisibleRange(
                minimumU - margin, maximumU + margin, minimumV - margin, maximumV + margin, leastW, largestW);
    }

    /** Returns a text for cache keys; all uses of the same intervals share tables. */
    @Override
    public String toString() {
        return Text.format(
                "u from %s to %s, v from %s to %s, |w| from %s to %s",
                minimumU, maximumU, minimumV, maximumV, minimumW, maximumW);
    }

    /** Returns the bins along x visible at 380 nm or longer, with a margin on both sides. */
    public Band bandX(double period, int margin) {
        return band(minimumU, maximumU, period, margin);
    }

    public Band bandY(double period, int margin) {
        return band(minimumV, maximumV, period, margin);
    }

    private static double wavelengthTowards(double u, int side) {
        return side * u > 0 ? CieTable.MINIMUM_WAVELENGTH : CieTable.MAXIMUM_WAVELENGTH;
    }

    private static Band band(double low, double high, double period, int margin) {
        return Band.covering(low / wavelengthTowards(low, -1), high / wavelengthTowards(high, 1), period, margin);
    }

    /** Returns the largest |(u, v)|; that of any two directions is 2. */
    public double longestUv() {
        return Math.min(2, Math.hypot(largest(minimumU, maximumU), largest(minimumV, maximumV)));
    }

    /** Returns the largest of |u| and |v|. */
    public double maximumComponent() {
        return Math.max(largest(minimumU, maximumU), largest(minimumV, maximumV));
    }

    /** Returns the larger magnitude of two ends of a range. */
    public static double largest(double low, double high) {
        return Math.max(Math.abs(low), Math.abs(high));
    }
}
