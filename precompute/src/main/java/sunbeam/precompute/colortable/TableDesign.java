package sunbeam.precompute.colortable;

import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Resolution of a table of colors, by laws that were measured (docs/color-tables.md) on the thesis's patches, both averages, 720 directions
 * each, half of them on the axis of gratings' orders.
 *
 * @param step of (u, v) between texels, above 0
 * @param slices of |w| from 0 to 2, equally spaced, at least {@link #TAPS}
 */
public record TableDesign(double step, int slices) {
    /** Slices per interpolation. */
    public static final int TAPS = 4;

    // Tolerance at which the steps were measured in sunlight: 95th percentiles of 2e-3 and 8e-4.
    private static final double TOLERANCE = 1e-3;
    private static final double STEP = 0.0018;
    private static final double SLICE_STEP = 0.1;
    // Relief of the deepest of the patches, meters.
    private static final double RELIEF = 0.82e-6;
    // Effective relief in standard deviations: for gratings of few heights the whole relief turns phases. Colors vary
    // along w as cos(2 pi relief w / wavelength), and slices are 0.06 periods apart at 1e-3.
    private static final double RELIEF_OF_DEVIATION = 8.5;
    // Exponent of the step in the error of cubic B-splines of square roots: between 4 and 6.
    private static final double STEP_ORDER = 5;
    // Exponent of the slice step in the error of cubic polynomials.
    private static final double SLICE_ORDER = 4;

    // Exponent of the coherence length for coherent averages, whose roots have kinks at zeros between speckles. The
    // spread of wavelengths fills the zeros for long windows; for 6 um, as measured, 0.7 of the step keeps the error.
    private static final double COHERENT_ORDER = 0.15;

    public TableDesign {
        if (!(step > 0) || slices < TAPS) {
            throw new IllegalArgumentException("step " + step + ", " + slices + " slices");
        }
    }

    /**
     * Returns the coarsest design that keeps a tolerance.
     *
     * @param tolerance relative error of X, Y, Z
     * @param area whose window's spectrum bounds features in (u, v), whatever the surface
     * @param relief see {@link #depth}, meters; proportional to the phase along w
     */
    public static TableDesign within(double tolerance, GaussianArea area, double relief) {
        double ratio = tolerance / TOLERANCE;
        double length = area.window().coherenceLength() / CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH;
        double zeros = area.average() == Average.COHERENT ? Math.min(1, Math.pow(length, COHERENT_ORDER)) : 1;
        double step = STEP * Math.pow(ratio, 1 / STEP_ORDER) / length * zeros;
        double sliceStep = SLICE_STEP * Math.pow(ratio, 1 / SLICE_ORDER) * Math.min(1, RELIEF / relief);
        return new TableDesign(step, Math.max(TAPS, 1 + (int) Math.ceil(2 / sliceStep)));
    }

    /** Returns the effective relief in meters: that of a mostly flat surface, like those measured, whose colors vary along w as fast. */
    public static double depth(HeightMap map) {
        double deviation = Math.sqrt(StatUtils.populationVariance(map.heights()));
        return Math.max(map.relief(), RELIEF_OF_DEVIATION * deviation);
    }

    /** Returns the design with all steps times a factor. */
    public TableDesign scaled(double factor) {
        return new TableDesign(step * factor, Math.max(TAPS, 1 + (int) Math.ceil((slices - 1) / factor)));
    }

    /** Returns the distance of slices in |w|. */
    public double sliceStep() {
        return 2.0 / (slices - 1);
    }
}
