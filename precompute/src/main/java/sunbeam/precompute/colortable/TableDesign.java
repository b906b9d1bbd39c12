package sunbeam.precompute.colortable;

import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * How fine a table of colors is. The laws are measured (docs/color-tables.md): on the thesis's patches, both averages, 720
 * directions each, half of them on the axis where gratings have their orders.
 *
 * @param step of (u, v) between texels, above 0
 * @param slices of |w| from 0 to 2, at equal distances, at least {@link #TAPS}
 */
public record TableDesign(double step, int slices) {
    /** Slices that are interpolated between. */
    public static final int TAPS = 4;

    // Tolerance and coherence length at which the steps below were measured: 95th percentiles of 2e-3 and 8e-4.
    private static final double TOLERANCE = 1e-3;
    private static final double STEP = 0.0018;
    private static final double SLICE_STEP = 0.1;
    // Relief of the deepest of the patches, metres.
    private static final double RELIEF = 0.82e-6;
    // Of a grating with two heights, or few, all of the relief turns phases, not just what sticks out: such colors go
    // up and down along w as cos(2 pi relief w / wavelength) does, and slices lie 0.06 of that apart at 1e-3.
    private static final double RELIEF_OF_DEVIATION = 8.5;
    // The error of a cubic B-spline in square roots of colors grows between the fourth and the sixth power of its
    // step.
    private static final double STEP_ORDER = 5;
    // That of a cubic polynomial through four slices grows with the fourth.
    private static final double SLICE_ORDER = 4;

    // Seen at one place, the surface has zeros between speckles, where roots have a kink. Long windows' speckles are
    // narrower than the spread of wavelengths, which fills the zeros; under a window of 6 um, measured, they are not,
    // and 0.7
    // of the step keeps the same error.
    private static final double COHERENT_ORDER = 0.15;

    public TableDesign {
        if (!(step > 0) || slices < TAPS) {
            throw new IllegalArgumentException("step " + step + ", " + slices + " slices");
        }
    }

    /**
     * The coarsest that keeps a tolerance.
     *
     * @param tolerance relative error of X, Y, Z
     * @param area features in (u, v) are as wide as the spectrum of its window, whatever the surface
     * @param relief what {@link #depth} says, metres; the phase along w grows with it
     */
    public static TableDesign within(double tolerance, GaussianArea area, double relief) {
        double ratio = tolerance / TOLERANCE;
        double length = area.window().coherenceLength() / CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH;
        double zeros = area.average() == Average.COHERENT ? Math.min(1, Math.pow(length, COHERENT_ORDER)) : 1;
        double step = STEP * Math.pow(ratio, 1 / STEP_ORDER) / length * zeros;
        double sliceStep = SLICE_STEP * Math.pow(ratio, 1 / SLICE_ORDER) * Math.min(1, RELIEF / relief);
        return new TableDesign(step, Math.max(TAPS, 1 + (int) Math.ceil(2 / sliceStep)));
    }

    /**
     * Relief, in metres, of a surface like those that the laws were measured on, mostly flat with some that sticks out, whose
     * colors change along w as fast as this one's.
     */
    public static double depth(HeightMap map) {
        double deviation = Math.sqrt(StatUtils.populationVariance(map.heights()));
        return Math.max(map.relief(), RELIEF_OF_DEVIATION * deviation);
    }

    /** With all steps times a factor. */
    public TableDesign scaled(double factor) {
        return new TableDesign(step * factor, Math.max(TAPS, 1 + (int) Math.ceil((slices - 1) / factor)));
    }

    /** Of |w| between slices. */
    public double sliceStep() {
        return 2.0 / (slices - 1);
    }
}
