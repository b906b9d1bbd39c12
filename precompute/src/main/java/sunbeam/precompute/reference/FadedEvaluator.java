package sunbeam.precompute.reference;

import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightMap;

/**
 * Diffracted power of a scan alone, without any repetition, by direct summation in double precision: the sum runs over the
 * scan only and is faded to zero at its border,
 *
 * <pre>
 * faded = |sum t p exp(i k (u x + v y)) / sum t|^2,   p = exp(i k w h),   t = cos^2(pi x / W) cos^2(pi y / H)
 * </pre>
 *
 * with x and y from the scan's middle and W and H its sides; an axis with one sample is not faded. 1 for a flat mirror in
 * specular direction. Its frequencies are continuous: nothing draws an order towards multiples of 1 / W. An order is 2 / W
 * wide at half its amplitude. Immutable and safe for use by several threads.
 */
public final class FadedEvaluator {
    private final SurfaceSums surface;
    private final Axis axisX;
    private final Axis axisY;

    /**
     * @param map heights without missing samples
     * @throws IllegalArgumentException when samples are missing
     */
    public FadedEvaluator(HeightMap map) {
        this.surface = new SurfaceSums(map);
        this.axisX = Axis.x(map, WindowOrigin.CENTRE);
        this.axisY = Axis.y(map, WindowOrigin.CENTRE);
    }

    /** The power, for a wavelength in metres. */
    public double power(DirectionPair pair, double wavelength) {
        AxisSums sums = surface.overRows(pair.w(), wavelength, AxisWeights.ofFade(pair.v() / wavelength, axisY));
        return sums.power(0, AxisWeights.ofFade(pair.u() / wavelength, axisX));
    }
}
