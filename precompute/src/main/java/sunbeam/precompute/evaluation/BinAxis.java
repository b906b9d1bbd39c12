package sunbeam.precompute.evaluation;

import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * DFT bins along one axis and the Gaussian over them.
 *
 * @param period of the patch, metres
 * @param sigmaFrequency standard deviation of the window's spectrum, cycles per metre
 * @param radius bins on each side of the nearest one that are summed
 */
record BinAxis(double period, double sigmaFrequency, int radius) {

    /** The bins within {@code reach} standard deviations of any frequency. */
    static BinAxis along(double period, CoherenceWindow window, double reach) {
        double bins = reach * window.sigmaFrequency() * period;
        int radius = (int) Math.ceil(Math.max(0, bins - 0.5));
        return new BinAxis(period, window.sigmaFrequency(), radius);
    }

    /** All bins that a grid's directions look at; {@code cosine} is the grating direction's component on the axis. */
    Band band(ResponseGrid grid, double cosine) {
        double[] wavelengths = grid.wavelengths();
        double low = Double.MAX_VALUE;
        double high = -Double.MAX_VALUE;
        for (double wavelength : new double[] {wavelengths[0], wavelengths[wavelengths.length - 1]}) {
            for (double u : new double[] {grid.minimumU(), grid.maximumU()}) {
                low = Math.min(low, u * cosine / wavelength);
                high = Math.max(high, u * cosine / wavelength);
            }
        }
        return Band.covering(low, high, period, radius + 1);
    }

    int count() {
        return 2 * radius + 1;
    }

    int nearest(double frequency) {
        return (int) Math.rint(frequency * period);
    }

    /** exp(-(f - f_j)^2 / (2 sigma_f^2)) for the bins around the nearest one. */
    void weigh(double frequency, double[] weights) {
        int first = nearest(frequency) - radius;
        for (int i = 0; i < weights.length; i++) {
            double distance = (frequency - (first + i) / period) / sigmaFrequency;
            weights[i] = Math.exp(-0.5 * distance * distance);
        }
    }
}
