package sunbeam.precompute.patch.builtin;

import java.util.SplittableRandom;

/**
 * Reproducible random numbers. Normal deviates use the transform of Box and Muller (Ann. Math. Statist. 29, 1958) with {@link StrictMath},
 * because the JDK does not specify the algorithm of {@code nextGaussian}.
 */
final class SeededNoise {
    private final SplittableRandom random;

    SeededNoise(long seed) {
        random = new SplittableRandom(seed);
    }

    /** In [0, 1). */
    double uniform() {
        return random.nextDouble();
    }

    /** Mean 0, standard deviation 1. */
    double normal() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - random.nextDouble()));
        return radius * StrictMath.cos(2 * StrictMath.PI * random.nextDouble());
    }
}
