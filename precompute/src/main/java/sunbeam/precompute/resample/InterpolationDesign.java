package sunbeam.precompute.resample;

import java.util.function.DoubleBinaryOperator;

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
 * @param error largest difference of both sides relative to the Gaussian there, down to the skirt it was made for, measured
 */
public record InterpolationDesign(double deviation, int taps, double beta, double error) {
    /** The most taps that a design is made for. */
    public static final int MOST_TAPS = 10;

    // Finer grids bend the Gaussian less between two samples, which is what its skirts need.
    private static final double[] DEVIATIONS = {1.6, 2, 2.5, 3, 4};
    // Of the shapes tried, 1.5 to 3.2 a tap, these leave the least, in the middle and on the skirts alike.
    private static final double[] BETA_PER_TAP = {2.5, 2.65, 2.8, 2.95};

    /**
     * The fewest taps, and then the coarsest grid, that keep an error.
     *
     * @param tolerance relative error, at any distance up to the skirt
     * @param skirt deviations of the Gaussian down to which it counts
     * @throws IllegalArgumentException when no design keeps it
     */
    public static InterpolationDesign within(double tolerance, double skirt) {
        InterpolationDesign finest = null;
        for (int taps = 3; taps <= MOST_TAPS; taps++) {
            // The finest grid has the smallest error: where it fails, so do the coarser ones.
            finest = best(DEVIATIONS[DEVIATIONS.length - 1], taps, skirt);
            if (finest.error <= tolerance) {
                return coarsest(taps, tolerance, skirt, finest);
            }
        }
        throw new IllegalArgumentException("interpolation reaches " + finest.error + " at best, not " + tolerance);
    }

    /**
     * The coarsest grid that keeps an error, for less memory, and then the fewest taps.
     *
     * @throws IllegalArgumentException when no design keeps it
     */
    public static InterpolationDesign compact(double tolerance, double skirt) {
        for (double deviation : DEVIATIONS) {
            for (int taps = 3; taps <= MOST_TAPS; taps++) {
                InterpolationDesign design = best(deviation, taps, skirt);
                if (design.error <= tolerance) {
                    return design;
                }
            }
        }
        throw new IllegalArgumentException("no interpolation keeps " + tolerance);
    }

    private static InterpolationDesign coarsest(int taps, double tolerance, double skirt, InterpolationDesign finest) {
        for (int i = 0; i < DEVIATIONS.length - 1; i++) {
            InterpolationDesign design = best(DEVIATIONS[i], taps, skirt);
            if (design.error <= tolerance) {
                return design;
            }
        }
        return finest;
    }

    /** The best kernel of a number of taps for a Gaussian of so many grid steps, down to a skirt in deviations. */
    public static InterpolationDesign best(double deviation, int taps, double skirt) {
        InterpolationDesign best = null;
        for (double perTap : BETA_PER_TAP) {
            double beta = perTap * taps;
            double error = new Spread(deviation, taps, beta).largestError(skirt);
            if (best == null || error < best.error) {
                best = new InterpolationDesign(deviation, taps, beta, error);
            }
        }
        return best;
    }

    /** phi at a distance in grid steps; 0 from taps / 2 on. */
    public double kernel(double distance) {
        return new KaiserBessel(taps, beta).value(distance);
    }

    /**
     * What stands for the Gaussian in double precision: sum_m phi(f - m) K(m - f_j) of f and f_j in grid steps. Safe for use
     * by several threads.
     */
    public DoubleBinaryOperator response() {
        return spread()::interpolated;
    }

    /** K, tabulated. */
    Spread spread() {
        return new Spread(deviation, taps, beta);
    }
}
