package sunbeam.precompute.expansion;

import sunbeam.precompute.patch.HeightLevels;

/**
 * Maps heights to s = (h - centre) / halfRange in [-1, 1] before any power of them is taken: k^n h^n in SI units leaves
 * the range of float32 and even of double. The centre only turns the phase of the whole surface, never its power.
 *
 * @param centre metres
 * @param halfRange metres, positive
 */
public record HeightScale(double centre, double halfRange) {
    // A flat patch has no range of its own; any positive one serves, and a picometre keeps its phase negligible.
    private static final double FLAT_HALF_RANGE = 1e-12;

    /** Centred on mid-range: the smallest half range there is. */
    public static HeightScale midRange(HeightLevels heights) {
        double centre = 0.5 * (heights.minimum() + heights.maximum());
        return new HeightScale(centre, Math.max(FLAT_HALF_RANGE, heights.maximum() - centre));
    }

    /** Centred on the mean, as in the thesis. */
    public static HeightScale mean(HeightLevels heights) {
        int[] counts = heights.histogram();
        double[] levels = heights.levels();
        double sum = 0;
        double samples = 0;
        for (int i = 0; i < counts.length; i++) {
            sum += counts[i] * (levels[i] - heights.minimum());
            samples += counts[i];
        }
        double centre = heights.minimum() + sum / samples;
        double reach = Math.max(heights.maximum() - centre, centre - heights.minimum());
        return new HeightScale(centre, Math.max(FLAT_HALF_RANGE, reach));
    }

    public double scaled(double height) {
        return (height - centre) / halfRange;
    }

    /** The phase zeta = k |w| halfRange for a wavelength in metres and |w| in 0..2. */
    public double phase(double wavelength, double absoluteW) {
        return 2 * Math.PI / wavelength * absoluteW * halfRange;
    }
}
