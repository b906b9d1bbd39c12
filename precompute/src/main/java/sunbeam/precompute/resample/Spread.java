package sunbeam.precompute.resample;

import sunbeam.precompute.numerics.KaiserBessel;

/** Function K of an {@link InterpolationDesign}: the Gaussian, divided by phi in the Fourier domain. */
final class Spread {
    private static final int SPECTRUM_SAMPLES = 256;
    // Distances at which the error of a design is measured, in standard deviations.
    private static final double DISTANCE_STEP = 0.6;
    // Between two grid points.
    private static final int POSITIONS = 4;
    // Standard deviations; exp(-7.5^2 / 2) = 6e-13.
    static final double GAUSS_REACH = 7.5;

    private final KaiserBessel kernel;
    private final double deviation;
    private final double[] spectrum;

    Spread(double deviation, int taps, double beta) {
        this.kernel = new KaiserBessel(taps, beta);
        this.deviation = deviation;
        this.spectrum = new double[SPECTRUM_SAMPLES + 1];
        for (int i = 0; i <= SPECTRUM_SAMPLES; i++) {
            double frequency = 0.5 * i / SPECTRUM_SAMPLES;
            double end = i == 0 || i == SPECTRUM_SAMPLES ? 0.5 : 1;
            spectrum[i] = end * gaussTransform(deviation, frequency) / kernel.transform(frequency);
        }
    }

    /** Relative to its maximum. */
    static double gaussTransform(double deviation, double frequency) {
        return Math.exp(-0.5 * Math.pow(2 * Math.PI * deviation * frequency, 2));
    }

    double reach() {
        return GAUSS_REACH * deviation + 0.5 * kernel.taps();
    }

    double value(double distance) {
        if (Math.abs(distance) > reach()) {
            return 0;
        }
        // cos(i angle) by rotation; a few hundred steps lose two digits of sixteen.
        double angle = Math.PI * distance / SPECTRUM_SAMPLES;
        double stepCosine = Math.cos(angle);
        double stepSine = Math.sin(angle);
        double cosine = 1;
        double sine = 0;
        double sum = 0;
        for (double value : spectrum) {
            sum += value * cosine;
            double next = cosine * stepCosine - sine * stepSine;
            sine = sine * stepCosine + cosine * stepSine;
            cosine = next;
        }
        return sum / SPECTRUM_SAMPLES * deviation * Math.sqrt(2 * Math.PI);
    }

    /** Returns the largest error of sum_m phi(f - m) K(m - f_j), relative to the Gaussian, over a skirt in its standard deviations. */
    double largestError(double skirt) {
        double largest = 0;
        int distances = (int) Math.ceil(skirt / DISTANCE_STEP);
        for (int i = 0; i <= distances; i++) {
            for (int place = 0; place < POSITIONS; place++) {
                double bin = (double) place / POSITIONS;
                // The offset of f from the grid point below varies with the distance.
                double f = bin + skirt * i / distances * deviation;
                double gauss = Math.exp(-0.5 * Math.pow((f - bin) / deviation, 2));
                largest = Math.max(largest, Math.abs(interpolated(f, bin) / gauss - 1));
            }
        }
        return largest;
    }

    /** Returns sum_m phi(f - m) K(m - bin), in grid steps. */
    double interpolated(double f, double bin) {
        double sum = 0;
        double half = 0.5 * kernel.taps();
        for (long m = (long) Math.ceil(f - half); m <= f + half; m++) {
            sum += kernel.value(f - m) * value(m - bin);
        }
        return sum;
    }
}
