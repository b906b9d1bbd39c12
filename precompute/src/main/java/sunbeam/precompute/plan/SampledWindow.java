package sunbeam.precompute.plan;

import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;

/**
 * A coherence window that the patch's samples show coarsely: its spectrum has replicas, one period of the sampling apart.
 *
 * @param window the Gaussian
 * @param map the samples
 */
record SampledWindow(CoherenceWindow window, HeightMap map) {

    // For the single row of a patch much longer than the window; with three samples in it the first alone counts.
    private static final int MOST_REPLICAS = 1000;

    /**
     * By how much a coherent power from DFT bins is too large, relative. By Poisson's sum the samples' sum is that many times
     * the integral: 1 + 2 sum_k exp(-2 pi^2 k^2 s^2 / pitch^2) along an axis, and its square is between the powers. Within one period of the sampling around a bright order that is all.
     */
    double coherentError() {
        return Math.pow(sumByIntegral(map.pitchX()) * sumByIntegral(map.pitchY()), 2) - 1;
    }

    private double sumByIntegral(double pitch) {
        double sum = 1;
        for (int k = 1; k <= MOST_REPLICAS; k++) {
            sum += 2 * Math.exp(-2 * Math.pow(Math.PI * k * window.sigmaMetres() / pitch, 2));
        }
        return sum;
    }

    /** The larger distance of samples, metres; that of a single row to its next replica, too. */
    double pitch() {
        return Math.max(map.pitchX(), map.pitchY());
    }

    /**
     * By how much of all light the mean over positions on samples differs from the mean over all. Neighbouring replicas interfere
     * in the first only: exp(-F^2 / (4 sigma_f^2)) of the light along an axis, F = 1 / pitch, on both sides.
     */
    double positionsDifference() {
        return interference(map.columns(), map.pitchX()) + interference(map.rows(), map.pitchY());
    }

    private double interference(int samples, double pitch) {
        double periods = 1 / (pitch * window.sigmaFrequency());
        return samples == 1 ? 0 : 2 * Math.exp(-0.25 * periods * periods);
    }
}
