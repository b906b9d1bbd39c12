package sunbeam.precompute.spectrum;

import sunbeam.precompute.numerics.KaiserBessel;

/**
 * Interpolation between the DFT bins of one period with sharp edges (thesis section 3.5), p_n being one of the N samples, at x_n:
 *
 * <pre>P_1(f) = 1/N sum_n p_n exp(2 pi i f x_n), x = 0 in the middle of the period</pre>
 */
public enum PeriodInterpolation {
    /**
     * The DFT's own interpolation, sum_j P_1(f_j) sin(pi (f - f_j) L) / (N sin(pi (f - f_j) pitch)) for a period of length L. A truncated
     * kernel would lose the specular order's tails, which outshine the rest of a rough patch; so the period is padded with zeros to twice
     * its length, and seven taps of a Kaiser-Bessel kernel, whose transform is divided out (Jackson et al. 1991), interpolate. Error below
     * 1e-7 of the largest amplitude, as measured.
     */
    SINC(2, 7),
    /** Linear interpolation between neighboring bins; exact only on the bins. */
    LINEAR(1, 2),
    /**
     * The thesis's interpolation over the bin below and its eight neighbors, weighted by sin(pi r) / (pi r) of their distance r in bins.
     * Phases refer to the period's corner and turn by pi from bin to bin.
     */
    RING(1, 3);

    private final int oversampling;
    private final int taps;

    PeriodInterpolation(int oversampling, int taps) {
        this.oversampling = oversampling;
        this.taps = taps;
    }

    public int oversampling() {
        return oversampling;
    }

    public int taps() {
        return taps;
    }

    public int margin() {
        // One more, because float32 may round a frequency into the next sample.
        return taps / 2 + 1;
    }

    public double kernel(double distance) {
        return switch (this) {
            case SINC -> kaiserBessel().value(distance);
            case LINEAR -> Math.max(0, 1 - Math.abs(distance));
            case RING -> throw new IllegalStateException("no kernel along one axis");
        };
    }

    /** Undoes the kernel's attenuation at a position, in -1/2..1/2 of the period. */
    double correction(double place) {
        return this == SINC ? 1 / kaiserBessel().transform(place / oversampling) : 1;
    }

    // The first zero of the transform lies at the nearest alias of the period's edge, 1 - 1 / (2 oversampling).
    private KaiserBessel kaiserBessel() {
        double alias = Math.PI * taps * (1 - 0.5 / oversampling);
        return new KaiserBessel(taps, Math.sqrt(alias * alias - Math.PI * Math.PI));
    }
}
