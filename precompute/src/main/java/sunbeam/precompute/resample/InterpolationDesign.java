package sunbeam.precompute.resample;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.numerics.KaiserBessel;

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
    private static final int FEWEST_TAPS = 3;
    private static final int MOST_TAPS = 10;

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
        double finest = DEVIATIONS[DEVIATIONS.length - 1];
        return first(
                tolerance,
                IntStream.rangeClosed(FEWEST_TAPS, MOST_TAPS)
                        // Where the finest grid fails, so do the coarser ones.
                        .filter(taps -> best(finest, taps, skirt).error <= tolerance)
                        .boxed()
                        .flatMap(taps -> Arrays.stream(DEVIATIONS).mapToObj(grid -> best(grid, taps, skirt))));
    }

    /**
     * The coarsest grid that keeps an error, for less memory, and then the fewest taps.
     *
     * @throws IllegalArgumentException when no design keeps it
     */
    public static InterpolationDesign compact(double tolerance, double skirt) {
        return first(
                tolerance,
                Arrays.stream(DEVIATIONS)
                        .boxed()
                        .flatMap(grid -> IntStream.rangeClosed(FEWEST_TAPS, MOST_TAPS)
                                .mapToObj(taps -> best(grid, taps, skirt))));
    }

    private static InterpolationDesign first(double tolerance, Stream<InterpolationDesign> tried) {
        return tried.filter(design -> design.error <= tolerance)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no interpolation keeps " + tolerance));
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

    Spread spread() {
        return new Spread(deviation, taps, beta);
    }
}
