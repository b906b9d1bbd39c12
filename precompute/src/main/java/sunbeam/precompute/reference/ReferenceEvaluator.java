package sunbeam.precompute.reference;

import java.util.Arrays;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Geometry;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightMap;

/**
 * Diffracted power of a patch by direct summation in double precision (design section 3):
 *
 * <pre>
 * coherent = |sum g p exp(i k (u x + v y)) / sum g|^2,   p = exp(i k w h)
 * ensemble = sum_j |F_j|^2 exp(-|f - f_j|^2 / sigma_f^2)
 * </pre>
 *
 * The sums are exact for the patch repeated without end: replicas only change the weights of the one period's samples,
 * which are folded per axis before the sum. Rounding error about 2e-15 / sqrt(power), relative. Immutable and safe for
 * use by several threads.
 */
public final class ReferenceEvaluator {
    // Where the Gaussian's tails end: exp(-9^2 / 2) = 3e-18 in amplitude, exp(-6.8^2) = 8e-21 in power.
    private static final double AMPLITUDE_REACH = 9;
    private static final double POWER_REACH = 6.8;

    private final HeightMap map;
    private final SurfaceSums surface;
    private final CoherenceWindow window;
    private final WindowOrigin origin;

    /**
     * @param map heights without missing samples
     * @throws IllegalArgumentException when samples are missing
     */
    public ReferenceEvaluator(HeightMap map, CoherenceWindow window, WindowOrigin origin) {
        this.map = map;
        this.surface = new SurfaceSums(map);
        this.window = window;
        this.origin = origin;
    }

    /** Both averages of the power. */
    public record Power(double coherent, double ensemble) {}

    /** Power of one coherence area, for a wavelength in metres; 1 for a flat mirror in specular direction. */
    public double coherent(Geometry geometry, double wavelength) {
        AxisWeights alongY = windowWeights(geometry.v() / wavelength, Axis.y(map, origin));
        AxisSums sums = surface.overRows(geometry.w(), wavelength, alongY);
        return sums.power(0, windowWeights(geometry.u() / wavelength, Axis.x(map, origin)));
    }

    /** Power of one coherence area and its mean over all positions of the window, for a wavelength in metres. */
    public Power powers(Geometry geometry, double wavelength) {
        double fx = geometry.u() / wavelength;
        double fy = geometry.v() / wavelength;
        Axis x = Axis.x(map, origin);
        Axis y = Axis.y(map, origin);
        int[] binsX = binsNear(fx, x);
        int[] binsY = binsNear(fy, y);
        AxisWeights[] alongY = new AxisWeights[binsY.length + 1];
        for (int i = 0; i < binsY.length; i++) {
            alongY[i] = AxisWeights.ofBin(binsY[i], y);
        }
        alongY[binsY.length] = windowWeights(fy, y);
        AxisSums sums = surface.overRows(geometry.w(), wavelength, alongY);
        double ensemble = 0;
        for (int jx : binsX) {
            AxisWeights alongX = AxisWeights.ofBin(jx, x);
            double gaussX = powerGauss(fx - jx / x.period());
            for (int i = 0; i < binsY.length; i++) {
                ensemble += gaussX * powerGauss(fy - binsY[i] / y.period()) * sums.power(i, alongX);
            }
        }
        return new Power(sums.power(binsY.length, windowWeights(fx, x)), ensemble);
    }

    private double powerGauss(double frequency) {
        double ratio = frequency / window.sigmaFrequency();
        return Math.exp(-ratio * ratio);
    }

    private AxisWeights windowWeights(double frequency, Axis axis) {
        return AxisWeights.ofWindow(frequency, axis, window.sigmaMetres(), AMPLITUDE_REACH);
    }

    private int[] binsNear(double frequency, Axis axis) {
        double reach = POWER_REACH * window.sigmaFrequency() * axis.period();
        int first = (int) Math.ceil(frequency * axis.period() - reach);
        int last = (int) Math.floor(frequency * axis.period() + reach);
        int[] bins = new int[Math.max(0, last - first + 1)];
        Arrays.setAll(bins, i -> first + i);
        return bins;
    }
}
