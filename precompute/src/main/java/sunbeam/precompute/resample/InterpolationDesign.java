package sunbeam.precompute.resample;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.numerics.KaiserBessel;

/**
 * Design of an interpolation that replaces a Gaussian of the frequency by a few taps on a grid:
 *
 * <pre>exp(-(f - f_j)^2 / (2 deviation^2)) = sum_m phi(f - m) K(m - f_j), all in grid steps</pre>
 *
 * <p>phi is a Kaiser-Bessel kernel that the GPU evaluates at a few grid points m around f. K spreads the DFT bins onto the grid beforehand;
 * it is the Gaussian with phi divided out of its transform (the deconvolution of gridding: Jackson et al. 1991; Greengard and Lee 2004).
 * The error is aliasing, small because the Gaussian's transform, the coherence window, fades before the kernel's.
 *
 * @param deviation standard deviation of the Gaussian in grid steps
 * @param beta shape parameter of phi, without unit
 * @param error largest difference between both sides, relative to the Gaussian, over the skirt of the design; measured
 */
public record InterpolationDesign(double deviation, int taps, double beta, double error) {
    private static final int FEWEST_TAPS = 3;
    private static final int MOST_TAPS = 10;

    // On finer grids the Gaussian bends less between samples, which makes its skirts exact.
    private static final double[] DEVIATIONS = {1.6, 2, 2.5, 3, 4};
    // These err least of 1.5 to 3.2, both in the middle and on the skirts.
    private static final double[] BETA_PER_TAP = {2.5, 2.65, 2.8, 2.95};

    /**
     * Returns the design within an error that has the fewest taps, and of those the coarsest grid.
     *
     * @param tolerance relative error at any distance within the skirt
     * @param skirt standard deviations of the Gaussian over which the error is bounded
     * @throws IllegalArgumentException if there is none
     */
    public static InterpolationDesign within(double tolerance, double skirt) {
        double finest = DEVIATIONS[DEVIATIONS.length - 1];
        return first(
                tolerance,
                IntStream.rangeClosed(FEWEST_TAPS, MOST_TAPS)
                        // If the finest grid fails, so do the coarser ones.
                        .filter(taps -> best(finest, taps, skirt).error <= tolerance)
                        .boxed()
                        .flatMap(taps -> Arrays.stream(DEVIATIONS).mapToObj(grid -> best(grid, taps, skirt))));
    }

    /** Returns the design within an error that has the coarsest grid, to save memory, and of those the fewest taps. */
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

    /** Returns the best kernel for a number of taps, a Gaussian's deviation in grid steps, and a skirt in deviations. */
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

    /** Returns phi at a distance in grid steps; 0 from taps / 2 on. */
    public double kernel(double distance) {
        return new KaiserBessel(taps, beta).value(distance);
    }

    Spread spread() {
        return new Spread(deviation, taps, beta);
    }
}
