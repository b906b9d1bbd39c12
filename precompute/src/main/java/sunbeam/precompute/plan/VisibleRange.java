package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.resample.AxisGrid;
import sunbeam.precompute.text.Text;

/**
 * The (u, v, w) that a scene can reach, as intervals: nothing outside is computed or stored.
 *
 * @param minimumW smallest |w|, 0..2
 * @param maximumW largest |w|, 0..2
 * @param reach what of the intervals it is, for tables of single (u, v, w)
 */
public record VisibleRange(
        double minimumU,
        double maximumU,
        double minimumV,
        double maximumV,
        double minimumW,
        double maximumW,
        Reach reach) {

    /** All of some intervals. */
    public VisibleRange(
            double minimumU, double maximumU, double minimumV, double maximumV, double minimumW, double maximumW) {
        this(minimumU, maximumU, minimumV, maximumV, minimumW, maximumW, new Reach.Everything());
    }

    /** Every pair of directions of the hemisphere. */
    public static VisibleRange all() {
        return new VisibleRange(-2, 2, -2, 2, 0, 2);
    }

    /** One light, every direction to the viewer: a BRDF map. */
    public static VisibleRange of(Direction light) {
        return new VisibleRange(
                -light.x() - 1,
                -light.x() + 1,
                -light.y() - 1,
                -light.y() + 1,
                light.z(),
                light.z() + 1,
                new Reach.OneLight(light));
    }

    /** The smallest range that holds all of some pairs of directions; at least one is needed. */
    public static VisibleRange of(Iterable<DirectionPair> pairs) {
        double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
        double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        List<DirectionPair> all = new ArrayList<>();
        for (DirectionPair pair : pairs) {
            all.add(pair);
            double[] uvw = {pair.u(), pair.v(), -pair.w()};
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], uvw[axis]);
                high[axis] = Math.max(high[axis], uvw[axis]);
            }
        }
        if (low[0] > high[0]) {
            throw new IllegalArgumentException("no directions");
        }
        return new VisibleRange(low[0], high[0], low[1], high[1], low[2], high[2], new Reach.Pairs(all));
    }

    /** The intervals: part of the keys under which tables are kept that hold all of them. */
    @Override
    public String toString() {
        return Text.format(
                "u from %s to %s, v from %s to %s, |w| from %s to %s",
                minimumU, maximumU, minimumV, maximumV, minimumW, maximumW);
    }

    /** Bins along x that can be seen at a wavelength of 380 nm or longer, and a margin on both sides. */
    public Band bandX(double period, int margin) {
        return band(minimumU, maximumU, period, margin);
    }

    /** Bins along y that can be seen at a wavelength of 380 nm or longer, and a margin on both sides. */
    public Band bandY(double period, int margin) {
        return band(minimumV, maximumV, period, margin);
    }

    /** Samples along x of the frequencies that can be seen at 380 nm or longer, and a margin on both sides. */
    public AxisGrid gridX(double step, int margin) {
        return grid(minimumU, maximumU, step, margin);
    }

    /** Samples along y of the frequencies that can be seen at 380 nm or longer, and a margin on both sides. */
    public AxisGrid gridY(double step, int margin) {
        return grid(minimumV, maximumV, step, margin);
    }

    private static AxisGrid grid(double low, double high, double step, int margin) {
        return AxisGrid.covering(low / wavelengthTowards(low, -1), high / wavelengthTowards(high, 1), step, margin);
    }

    /** The wavelength at which u / lambda reaches farthest towards one side. */
    private static double wavelengthTowards(double u, int side) {
        return side * u > 0 ? CieTable.MINIMUM_WAVELENGTH : CieTable.MAXIMUM_WAVELENGTH;
    }

    private static Band band(double low, double high, double period, int margin) {
        return Band.covering(low / wavelengthTowards(low, -1), high / wavelengthTowards(high, 1), period, margin);
    }

    /** Longest (u, v): no two directions of the hemisphere have a longer one than 2. */
    public double longestUv() {
        double u = Math.max(Math.abs(minimumU), Math.abs(maximumU));
        double v = Math.max(Math.abs(minimumV), Math.abs(maximumV));
        return Math.min(2, Math.hypot(u, v));
    }

    /** Largest of |u| and |v|. */
    public double maximumComponent() {
        return Math.max(
                Math.max(Math.abs(minimumU), Math.abs(maximumU)), Math.max(Math.abs(minimumV), Math.abs(maximumV)));
    }
}
