package sunbeam.precompute.patch.builtin;

import java.util.SplittableRandom;

/**
 * Reproducible random numbers: the same seed gives the same patch on every run. Normal deviates
 * are made here (Box and Muller, Ann. Math. Statist. 29, 1958) with {@link StrictMath}, because the library leaves the
 * algorithm of {@code nextGaussian} open.
 */
final class SeededNoise {
    private final SplittableRandom random;

    SeededNoise(long seed) {
        random = new SplittableRandom(seed);
    }

    /** Uniform in [0, 1). */
    double uniform() {
        return random.nextDouble();
    }

    /** Normal with mean 0 and standard deviation 1. */
    double normal() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - random.nextDouble()));
        return radius * StrictMath.cos(2 * StrictMath.PI * random.nextDouble());
    }
}
