package sunbeam.precompute.spectrum;

import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;

/**
 * Linear map of heights h to s = (h - center) / halfRange in [-1, 1], in meters: k^n and h^n in SI units exceed the range of float32 and
 * even of double. The center changes the phase of the whole surface only, never its power.
 */
public record HeightScale(double center, double halfRange) {
    // Meters, for a flat patch; the phase of a picometer is negligible.
    private static final double FLAT_HALF_RANGE = 1e-12;

    public static HeightScale midRange(HeightMap heights) {
        double center = 0.5 * (heights.minimum() + heights.maximum());
        return new HeightScale(center, Math.max(FLAT_HALF_RANGE, heights.maximum() - center));
    }

    /** Returns the scale centered on the mean height, as in the thesis. */
    public static HeightScale mean(HeightMap heights) {
        double center = StatUtils.mean(heights.heights());
        double reach = Math.max(heights.maximum() - center, center - heights.minimum());
        return new HeightScale(center, Math.max(FLAT_HALF_RANGE, reach));
    }

    public double scaled(double height) {
        return (height - center) / halfRange;
    }

    /** Returns the phase zeta = k |w| halfRange in radians, for a wavelength in meters and |w| in 0..2. */
    public double phase(double wavelength, double absoluteW) {
        return 2 * Math.PI / wavelength * absoluteW * halfRange;
    }
}
