package sunbeam.precompute.colortable;

import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Resolution of a color table, by laws measured on the thesis's patches (docs/color-tables.md): steps in u and v, above 0, and at least
 * {@link #TAPS} slices, equally spaced over |w| from 0 to 2.
 */
public record TableDesign(double step, int slices) {
    /** Slices that an interpolation along w reads. */
    public static final int TAPS = 4;
    // Tolerance at which the following steps, in (u, v) and in |w|, were measured in sunlight.
    private static final double TOLERANCE = 1e-3;
    private static final double STEP = 0.0018;
    private static final double SLICE_STEP = 0.1;
    // Relief of the deepest measured patch, meters.
    private static final double RELIEF = 0.82e-6;
    // In standard deviations of the heights: in gratings of few heights all samples have extreme heights. Colors vary
    // along w as cos(2 pi relief w / wavelength).
    private static final double RELIEF_OF_DEVIATION = 8.5;
    // Exponents of the steps in the errors: between 4 and 6 for cubic B-splines of square roots.
    private static final double STEP_ORDER = 5;
    private static final double SLICE_ORDER = 4;
    // Exponent of the coherence length for coherent averages, whose roots have kinks at the zeros between speckles;
    // under long windows these are filled, since each wavelength has them elsewhere.
    private static final double COHERENT_ORDER = 0.15;

    /** Returns the coarsest design that keeps a tolerance under a window, for an effective relief in meters ({@link #depth}). */
    public static TableDesign within(double tolerance, GaussianArea area, double relief) {
        double ratio = tolerance / TOLERANCE;
        double length = area.window().coherenceLength() / CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH;
        double zeros = area.average() == Average.COHERENT ? Math.min(1, Math.pow(length, COHERENT_ORDER)) : 1;
        double step = STEP * Math.pow(ratio, 1 / STEP_ORDER) / length * zeros;
        double sliceStep = SLICE_STEP * Math.pow(ratio, 1 / SLICE_ORDER) * Math.min(1, RELIEF / relief);
        return new TableDesign(step, Math.max(TAPS, 1 + (int) Math.ceil(ColorTable.DEEPEST / sliceStep)));
    }

    /** Returns the relief, in meters, of a mostly flat surface whose colors vary as fast along w. */
    public static double depth(HeightMap map) {
        return Math.max(map.relief(), RELIEF_OF_DEVIATION * Math.sqrt(StatUtils.populationVariance(map.heights())));
    }

    public TableDesign scaled(double factor) {
        return new TableDesign(step * factor, Math.max(TAPS, 1 + (int) Math.ceil((slices - 1) / factor)));
    }

    public double sliceStep() {
        return ColorTable.DEEPEST / (slices - 1);
    }
}
