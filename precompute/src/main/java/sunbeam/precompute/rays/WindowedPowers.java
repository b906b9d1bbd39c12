package sunbeam.precompute.rays;

import sunbeam.precompute.optics.CoherenceWindow;

/**
 * The terms of a surface's powers, at any frequency, under a window: sums of Gaussians around the DFT bins, in
 * double precision. Immutable.
 */
final class WindowedPowers {
    private final BinPlane bins;
    private final BinPlane turned;
    private final double sigmaFrequency;
    private final double reach;

    /**
     * Powers under a window.
     *
     * @param turned the same bins, rows as columns
     * @param reach in the window's sigma_f, beyond which a bin is left out: exp(-reach^2) of it
     */
    WindowedPowers(BinPlane bins, BinPlane turned, CoherenceWindow window, double reach) {
        this.bins = bins;
        this.turned = turned;
        this.sigmaFrequency = window.sigmaFrequency();
        this.reach = reach;
    }

    int terms() {
        return bins.terms();
    }

    /** Values of each knot that {@link RayFan} puts: the terms, and zeros behind them. */
    int stride() {
        return bins.stride();
    }

    /**
     * All terms at frequencies on a ray from the origin.
     *
     * @param cosine of the ray's angle
     * @param sine of the ray's angle
     * @param frequencies cycles per metre
     * @param terms where they are put, {@code [term][frequency]}
     */
    void alongRay(double cosine, double sine, double[] frequencies, double[][] terms) {
        GaussianWeights x = weights(bins.periodX());
        GaussianWeights y = weights(bins.periodY());
        double[] sums = new double[bins.stride()];
        for (int i = 0; i < frequencies.length; i++) {
            x.moveTo(cosine * frequencies[i] * bins.periodX() - bins.firstX(), 0, bins.columns() - 1);
            y.moveTo(sine * frequencies[i] * bins.periodY() - bins.firstY(), 0, bins.rows() - 1);
            for (int m = 0; m < sums.length; m += BinPlane.TOGETHER) {
                sum(x, y, sums, m);
            }
            for (int m = 0; m < terms.length; m++) {
                terms[m][i] = sums[m];
            }
        }
    }

    /** Four terms at a time: their sums stay in registers. */
    private void sum(GaussianWeights x, GaussianWeights y, double[] sums, int m) {
        double[] powers = bins.powers();
        int stride = bins.stride();
        double sum0 = 0;
        double sum1 = 0;
        double sum2 = 0;
        double sum3 = 0;
        for (int j = 0; j < y.count(); j++) {
            int at = ((y.first() + j) * bins.columns() + x.first()) * stride + m;
            for (int i = 0; i < x.count(); i++) {
                double weight = y.weight(j) * x.weight(i);
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

    private GaussianWeights weights(double period) {
        return new GaussianWeights(1 / (sigmaFrequency * period), reach);
    }

    /**
     * Prepares rays that lie beside each other, all of them closest to the same axis.
     *
     * @param firstAngle of the rays
     * @param lastAngle of the rays, less than 90 degrees beyond the first
     * @param knots what will be asked for
     */
    RayFan fan(double firstAngle, double lastAngle, LogKnots knots) {
        boolean alongX = isAlongX(0.5 * (firstAngle + lastAngle));
        return new RayFan(alongX ? turned : bins, alongX, sigmaFrequency, reach, firstAngle, lastAngle, knots);
    }

    /** Whether a ray lies closer to the x axis than to the y axis. */
    static boolean isAlongX(double angle) {
        return Math.abs(Math.cos(angle)) >= Math.abs(Math.sin(angle));
    }
}
