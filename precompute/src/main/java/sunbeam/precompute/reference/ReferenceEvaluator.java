package sunbeam.precompute.reference;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.SurfaceSums.AxisWeights;
import sunbeam.precompute.reference.SurfaceSums.AxisWeights.Axis;

/**
 * Diffracted power of a patch by direct summation in double precision (docs/theory.md):
 *
 * <pre>
 * coherent = |sum g p exp(i k (u x + v y)) / sum g|^2,   p = exp(i k w h)
 * ensemble = sum_j |F_j|^2 exp(-|f - f_j|^2 / sigma_f^2)
 * </pre>
 *
 * <p>The sums are exact for the patch repeated without end: replicas only change the samples' weights, which are added up per axis before the
 * sum over samples. Rounding error about 2e-15 / sqrt(power), relative. Immutable and safe for use by several threads.
 */
public record ReferenceEvaluator(
        SurfaceSums surface, CoherenceWindow window, Axis axisX, Axis axisY, double[] windowX, double[] windowY) {
    // In sigma and sigma_f: the amplitude is below exp(-9^2 / 2) = 3e-18, the power below exp(-6.8^2) = 8e-21.
    private static final double AMPLITUDE_REACH = 9;
    private static final double POWER_REACH = 6.8;

    /** Throws IllegalArgumentException if samples are missing. */
    public ReferenceEvaluator(HeightMap map, CoherenceWindow window, WindowOrigin origin) {
        this(
                SurfaceSums.of(map),
                window,
                Axis.x(map, origin),
                Axis.y(map, origin),
                Axis.x(map, origin).window(window.sigmaMeters(), AMPLITUDE_REACH),
                Axis.y(map, origin).window(window.sigmaMeters(), AMPLITUDE_REACH));
    }

    /** Power of one coherence area, and its mean over all positions of the window. */
    public record Power(double coherent, double ensemble) {}

    /** Coherent light in one direction, and |mean of exp(i k w h)|^2: in mirror direction, the specular order's share of light. */
    public record Sample(double coherent, double specular) {}

    public HeightMap heights() {
        return surface.heights();
    }

    /** Returns the power of one coherence area at a wavelength in meters; 1 for a flat mirror in specular direction. */
    public double coherent(DirectionPair pair, double wavelength) {
        return surface.overRows(pair.w(), wavelength, AxisWeights.ofWindow(pair.v() / wavelength, axisY, windowY))
                .power(0, AxisWeights.ofWindow(pair.u() / wavelength, axisX, windowX));
    }

    /** Returns the light at a wavelength in meters without {@link #heights()}, faster for a few directions of a scan of many levels. */
    public Sample sample(DirectionPair pair, double wavelength) {
        AxisWeights alongY = AxisWeights.ofWindow(pair.v() / wavelength, axisY, windowY);
        SurfaceSums.Sums sums = surface.overSamples(pair.w(), wavelength, alongY, AxisWeights.ofBin(0, axisY));
        return new Sample(
                sums.power(0, AxisWeights.ofWindow(pair.u() / wavelength, axisX, windowX)),
                sums.power(1, AxisWeights.ofBin(0, axisX)));
    }

    public Power powers(DirectionPair pair, double wavelength) {
        double[][] phases = phases(pair.w(), wavelength);
        return powers(phases[0], phases[1], pair.u() / wavelength, pair.v() / wavelength);
    }

    /** Returns the powers with a complex function of each of {@link #heights()}'s levels in place of p; frequencies in cycles per meter. */
    public Power powers(double[] real, double[] imaginary, double fx, double fy) {
        int[] binsX = binsNear(fx, axisX);
        int[] binsY = binsNear(fy, axisY);
        AxisWeights[] alongY = new AxisWeights[binsY.length + 1];
        Arrays.setAll(
                alongY,
                i -> i < binsY.length ? AxisWeights.ofBin(binsY[i], axisY) : AxisWeights.ofWindow(fy, axisY, windowY));
        SurfaceSums.Sums sums = surface.overRows(new double[][] {real, imaginary}, alongY);
        double ensemble = 0;
        for (int jx : binsX) {
            AxisWeights alongX = AxisWeights.ofBin(jx, axisX);
            double gaussX = powerGauss(fx - jx / axisX.period());
            for (int i = 0; i < binsY.length; i++) {
                ensemble += gaussX * powerGauss(fy - binsY[i] / axisY.period()) * sums.power(i, alongX);
            }
        }
        return new Power(sums.power(binsY.length, AxisWeights.ofWindow(fx, axisX, windowX)), ensemble);
    }

    /** Returns exp(i k w h) of each of {@link #heights()}'s levels, up to a constant phase: real parts, imaginary parts. */
    public double[][] phases(double w, double wavelength) {
        return surface.phases(w, wavelength);
    }

    private double powerGauss(double frequency) {
        return CoherenceWindow.power(frequency / window.sigmaFrequency());
    }

    double productCount(boolean ensemble) {
        int weightings = ensemble ? binsNear(0, axisY).length + 1 : 1;
        return (double) axisX.count() * axisY.count() * weightings;
    }

    private int[] binsNear(double frequency, Axis axis) {
        double reach = POWER_REACH * window.sigmaFrequency() * axis.period();
        int first = (int) Math.ceil(frequency * axis.period() - reach);
        int last = (int) Math.floor(frequency * axis.period() + reach);
        return IntStream.rangeClosed(first, last).toArray();
    }
}
