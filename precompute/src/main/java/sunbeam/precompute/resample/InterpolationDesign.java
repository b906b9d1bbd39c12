package sunbeam.precompute.resample;

/**
 * How a Gaussian of the frequency is replaced by a few taps on a grid:
 *
 * <pre>exp(-(f - f_j)^2 / (2 deviation^2)) = sum_m phi(f - m) K(m - f_j),  all in grid steps</pre>
 *
 * phi is a Kaiser-Bessel kernel that the GPU evaluates at a few grid points m around f; K, which spreads the DFT bins onto
 * the grid beforehand, is the Gaussian with phi divided out of its transform (the deconvolution of gridding: Jackson et al.
 * 1991; Greengard and Lee 2004). Only aliasing is left as error, and it is small because the Gaussian's transform, the
 * coherence window, has faded where the kernel's has.
 *
 * @param deviation standard deviation of the Gaussian in grid steps
 * @param taps grid points that phi reaches along one axis
 * @param beta shape of phi
 * @param error root mean square of the difference of both sides over that of the Gaussian, measured
 */
public record InterpolationDesign(double deviation, int taps, double beta, double error) {
    /** The most taps that a design is made for. */
    public static final int MOST_TAPS = 8;

    private static final double[] DEVIATIONS = {1.28, 1.45, 1.6, 1.75, 1.92, 2.2, 2.5};
    private static final int SPECTRUM_SAMPLES = 64;
    private static final int ALIASES = 4;
    private static final int BETA_CANDIDATES = 96;

    /**
     * The fewest taps, and then the coarsest grid, that keep an error.
     *
     * @throws IllegalArgumentException when no design keeps it
     */
    public static InterpolationDesign within(double tolerance) {
        InterpolationDesign finest = null;
        for (int taps = 2; taps <= MOST_TAPS; taps++) {
            // The finest grid has the smallest error: where it fails, so do the coarser ones.
            finest = best(DEVIATIONS[DEVIATIONS.length - 1], taps);
            if (finest.error <= tolerance) {
                return coarsest(taps, tolerance, finest);
            }
        }
        throw new IllegalArgumentException("interpolation reaches " + finest.error + " at best, not " + tolerance);
    }

    private static InterpolationDesign coarsest(int taps, double tolerance, InterpolationDesign finest) {
        for (int i = 0; i < DEVIATIONS.length - 1; i++) {
            InterpolationDesign design = best(DEVIATIONS[i], taps);
            if (design.error <= tolerance) {
                return design;
            }
        }
        return finest;
    }

    /** The best kernel of a number of taps for a Gaussian of so many grid steps. */
    public static InterpolationDesign best(double deviation, int taps) {
        double chosen = 0;
        double least = Double.MAX_VALUE;
        for (int i = 0; i < BETA_CANDIDATES; i++) {
            double beta = taps * (1 + 2.5 * i / BETA_CANDIDATES);
            double error = aliasing(new KaiserBessel(taps, beta), deviation);
            if (error < least) {
                least = error;
                chosen = beta;
            }
        }
        return new InterpolationDesign(deviation, taps, chosen, new Spread(deviation, taps, chosen).measuredError());
    }

    // Parseval over one period of the grid's spectrum: what the aliases carry, against what the Gaussian carries.
    private static double aliasing(KaiserBessel kernel, double deviation) {
        double aliases = 0;
        double signal = 0;
        for (int i = 0; i <= SPECTRUM_SAMPLES; i++) {
            double frequency = 0.5 * i / SPECTRUM_SAMPLES;
            double gauss = Spread.gaussTransform(deviation, frequency);
            double own = kernel.transform(frequency);
            if (own <= 0) {
                return Double.MAX_VALUE;
            }
            for (int n = -ALIASES; n <= ALIASES; n++) {
                if (n != 0) {
                    double alias = gauss / own * kernel.transform(frequency + n);
                    aliases += alias * alias;
                }
            }
            signal += gauss * gauss;
        }
        return Math.sqrt(aliases / signal);
    }

    /** phi at a distance in grid steps; 0 from taps / 2 on. */
    public double kernel(double distance) {
        return new KaiserBessel(taps, beta).value(distance);
    }

    /** K, tabulated. */
    Spread spread() {
        return new Spread(deviation, taps, beta);
    }
}
