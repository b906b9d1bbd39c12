package sunbeam.precompute.radial;

import sunbeam.precompute.spectrum.PowerSpectrum;

/** Gaussian weights exp(-(distance / sigma_f)^2) of the DFT bins within reach of a frequency, along one axis. Not thread-safe. */
final class GaussianWeights {
    private final double ratio;
    private final double reach;
    private final double factorStep;
    private final double[] weights;
    private int first;
    private int count;

    /** @param reach distance in sigma_f beyond which a bin is left out */
    GaussianWeights(PowerSpectrum.Axis bins, double sigmaFrequency, double reach) {
        // Distance between neighboring bins, divided by sigma_f.
        this.ratio = 1 / (sigmaFrequency * bins.period());
        this.reach = reach;
        this.factorStep = Math.exp(-2 * ratio * ratio);
        this.weights = new double[3 + (int) Math.ceil(2 * reach / ratio)];
    }

    /** Computes the weights around a position in bins, of which those from lowest to highest exist. */
    void moveTo(double place, int lowest, int highest) {
        first = (int) Math.max(lowest, Math.ceil(place - reach / ratio));
        int last = (int) Math.min(highest, Math.floor(place + reach / ratio));
        count = Math.max(0, last - first + 1);
        // exp(-(x + i r)^2) = exp(-x^2) exp(-2 x r)^i exp(-r^2)^(i^2): two exponentials instead of one per bin.
        double distance = (first - place) * ratio;
        double weight = Math.exp(-distance * distance);
        double factor = Math.exp(-(2 * distance + ratio) * ratio);
        for (int i = 0; i < count; i++) {
            weights[i] = weight;
            weight *= factor;
            factor *= factorStep;
        }
    }

    int first() {
        return first;
    }

    int count() {
        return count;
    }

    /** Only the first {@link #count()} are valid. */
    double[] weights() {
        return weights;
    }
}
