package sunbeam.precompute.colortable;

import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.spectrum.PowerSpectrum.GaussianWeights;

/** {@link PowerSpectrum} under a window: at any frequency, the sum of the bins' terms times Gaussians of their distance. Immutable. */
final class WindowedSpectrum {
    /** Largest spacing of decimated bins, in sigma_f: polynomials of degree 7 between them err by 1e-3. */
    private static final double DECIMATED_SPACING = 0.4;

    private final PowerSpectrum bins;
    private final double sigmaFrequency;
    private final double reach;

    /**
     * The window is no longer than the plan's; bins beyond {@code reach} sigma_f, of weights below exp(-reach^2), are left out; decimation
     * merges bins closer than 0.4 sigma_f, with an error of 1e-3.
     */
    WindowedSpectrum(PowerSpectrum spectrum, CoherenceWindow window, double reach, boolean decimated) {
        this.sigmaFrequency = window.sigmaFrequency();
        this.reach = reach;
        double spacing = decimated ? DECIMATED_SPACING * sigmaFrequency : 0;
        this.bins = spectrum.decimated((int) Math.max(1, spacing * spectrum.x().period()), (int)
                Math.max(1, spacing * spectrum.y().period()));
    }

    int stride() {
        return bins.stride();
    }

    double[] coefficients(double wavelength, double depth) {
        return bins.coefficients(wavelength, depth);
    }

    Sums sums() {
        return new Sums();
    }

    /** Not thread-safe. */
    final class Sums {
        private final GaussianWeights x = new GaussianWeights(bins.x(), sigmaFrequency, reach);
        private final GaussianWeights y = new GaussianWeights(bins.y(), sigmaFrequency, reach);
        private final double[] sums = new double[bins.stride()];

        private Sums() {}

        /** Returns all terms at a frequency in cycles per meter; overwritten by the next call. */
        double[] at(double fx, double fy) {
            x.moveTo(bins.x().place(fx), 0, bins.x().count() - 1);
            y.moveTo(bins.y().place(fy), 0, bins.y().count() - 1);
            for (int m = 0; m < sums.length; m += PowerSpectrum.TOGETHER) {
                sum(m);
            }
            return sums;
        }

        /** Sums four terms at a time, which stay in registers. */
        private void sum(int m) {
            double[] powers = bins.powers();
            int stride = bins.stride();
            double sum0 = 0;
            double sum1 = 0;
            double sum2 = 0;
            double sum3 = 0;
            for (int j = 0; j < y.count(); j++) {
                int at = ((y.first() + j) * bins.x().count() + x.first()) * stride + m;
                for (int i = 0; i < x.count(); i++) {
                    double weight = y.weights()[j] * x.weights()[i];
                    sum0 += weight * powers[at];
                    sum1 += weight * powers[at + 1];
                    sum2 += weight * powers[at + 2];
                    sum3 += weight * powers[at + 3];
                    at += stride;
                }
            }
            sums[m] = sum0;
            sums[m + 1] = sum1;
            sums[m + 2] = sum2;
            sums[m + 3] = sum3;
        }
    }

    /** Blurs the spectrum for rays, less than 90 degrees apart, that are closer to the same axis; angles from the x axis, radians. */
    RayBatch batch(double firstAngle, double lastAngle, RayBatch.Knots knots) {
        boolean alongX = isAlongX(0.5 * (firstAngle + lastAngle));
        PowerSpectrum crossed = alongX ? bins.transposed() : bins;
        return new RayBatch(crossed, alongX, sigmaFrequency, reach, firstAngle, lastAngle, knots);
    }

    static boolean isAlongX(double angle) {
        return Math.abs(Math.cos(angle)) >= Math.abs(Math.sin(angle));
    }
}
