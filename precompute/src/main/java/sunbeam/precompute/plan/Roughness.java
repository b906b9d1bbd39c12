package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ReferenceEvaluator;

/**
 * Statistics of the power that a patch diffracts in random directions, measured with the exact reference. A rough patch, which scatters
 * light everywhere, has no bare skirts, and approximation errors are small beside its light.
 *
 * @param bright share of directions with {@link ErrorBudget#DARKEST_POWER} or more, 0..1
 * @param mean power of these, relative to a mirror's
 * @param dark tenth percentile of their power
 * @param deviations width of the range of visible frequencies, in standard deviations of the window's spectrum
 * @param diffracted share of the light that does not go in mirror direction, 0..1; little if grains lie on a mirror
 */
public record Roughness(double bright, double mean, double dark, double deviations, double diffracted) {
    @FunctionalInterface
    public interface Cache {
        Cache NONE = (map, name, computation) -> computation.get();

        /** Returns cached or newly computed statistics; heights, name and the program's version determine them. */
        double[] get(HeightMap map, String name, Supplier<double[]> computation);
    }

    /** Lines, a mirror, or a grain of dust leave nearly all directions dark. */
    private static final double FEWEST_BRIGHT = 0.85;
    /** Below it orders are isolated: up to a tenth of a grating's directions are bright, most of a surface with any randomness. */
    private static final double FEWEST_LIT = 0.5;
    // With fewer deviations all light may be the skirt of one bright spot.
    private static final double FEWEST_DEVIATIONS = 60;
    // With less diffracted light a bare mirror's spot outshines a few grains, and its skirt shows.
    private static final double LEAST_DIFFRACTED = 0.02;
    private static final int MOST_TRIES = 1000;
    private static final int DIRECTIONS = 20;
    // Directions evaluated in parallel before the share of dark ones is checked.
    private static final int AT_ONCE = 4;
    private static final long SEED = 1936;
    /** Roughness of a patch that is not rough, or was not measured: its skirts count as bare. */
    public static final Roughness NONE = new Roughness(0, 1, 0, 0, 0);

    static Roughness measure(
            HeightMap map, CoherenceWindow window, WindowOrigin origin, VisibleRange range, Cache statistics) {
        double deviations = deviations(window, range);
        // Windows to which this roughness is applied later are shorter, and have fewer deviations.
        if (deviations < FEWEST_DEVIATIONS) {
            return NONE;
        }
        String name = "light of random directions under a coherence length of " + 1e6 * window.coherenceLength()
                + " um at the window's " + origin.name().toLowerCase(Locale.ROOT) + ", " + range;
        double[] numbers = statistics.get(
                map, name, () -> numbers(sample(new ReferenceEvaluator(map, window, origin), range), deviations));
        return new Roughness(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]);
    }

    private static List<ReferenceEvaluator.Sample> sample(ReferenceEvaluator source, VisibleRange range) {
        SplittableRandom random = new SplittableRandom(SEED);
        Query[] drawn = new Query[DIRECTIONS];
        Arrays.setAll(drawn, i -> draw(random, range));
        List<ReferenceEvaluator.Sample> samples = new ArrayList<>();
        while (samples.size() < DIRECTIONS && !isTooDark(samples)) {
            Arrays.stream(drawn, samples.size(), Math.min(samples.size() + AT_ONCE, DIRECTIONS))
                    .parallel()
                    .map(query -> source.sample(query.pair(), query.wavelength()))
                    .forEachOrdered(samples::add);
        }
        return samples;
    }

    private static boolean isTooDark(List<ReferenceEvaluator.Sample> samples) {
        return samples.stream().filter(sample -> !isBright(sample)).count() > (1 - FEWEST_BRIGHT) * DIRECTIONS;
    }

    private static boolean isBright(ReferenceEvaluator.Sample sample) {
        return sample.coherent() >= ErrorBudget.DARKEST_POWER;
    }

    /** Returns the components of a roughness; those of a patch that is too dark are {@link #NONE}'s. */
    private static double[] numbers(List<ReferenceEvaluator.Sample> samples, double deviations) {
        double[] powers = samples.stream()
                .filter(Roughness::isBright)
                .mapToDouble(ReferenceEvaluator.Sample::coherent)
                .sorted()
                .toArray();
        double bright = (double) powers.length / samples.size();
        if (isTooDark(samples)) {
            return new double[] {bright, NONE.mean, NONE.dark, NONE.deviations, NONE.diffracted};
        }
        double mean = Arrays.stream(powers).average().orElseThrow();
        double diffracted = samples.stream()
                .mapToDouble(sample -> Math.max(0, 1 - sample.specular()))
                .average()
                .orElseThrow();
        return new double[] {bright, mean, powers[powers.length / 10], deviations, diffracted};
    }

    private static double deviations(CoherenceWindow window, VisibleRange range) {
        double across = Math.max(range.maximumU() - range.minimumU(), range.maximumV() - range.minimumV());
        return across / CieTable.MAXIMUM_WAVELENGTH / window.sigmaFrequency();
    }

    /** Other statistics stay, since a shorter window only evens out bright and dark. */
    Roughness withWindow(CoherenceWindow window, VisibleRange range) {
        return new Roughness(bright, mean, dark, deviations(window, range), diffracted);
    }

    private record Query(DirectionPair pair, double wavelength) {}

    private static Query draw(SplittableRandom random, VisibleRange range) {
        Direction sum = new Direction(0, 0, 0);
        for (int i = 0; i < MOST_TRIES; i++) {
            sum = new Direction(
                    -between(random, range.minimumU(), range.maximumU()),
                    -between(random, range.minimumV(), range.maximumV()),
                    between(random, range.minimumW(), range.maximumW()));
            if (sum.dot(sum) <= 4) {
                break;
            }
        }
        double waveNumber = between(random, 1 / CieTable.MAXIMUM_WAVELENGTH, 1 / CieTable.MINIMUM_WAVELENGTH);
        // The pair is not two unit vectors: only their sum matters.
        return new Query(new DirectionPair(sum, new Direction(0, 0, 0)), 1 / waveNumber);
    }

    private static double between(SplittableRandom random, double low, double high) {
        return low + random.nextDouble() * (high - low);
    }

    public boolean areOrdersIsolated() {
        return bright < FEWEST_LIT;
    }

    public boolean isRough() {
        return bright >= FEWEST_BRIGHT && deviations >= FEWEST_DEVIATIONS && diffracted >= LEAST_DIFFRACTED;
    }

    /**
     * Returns the amplitude of dark directions relative to the mean one, times the square root of the diffracted share, 0..1: an
     * expansion's error at the phases of a few grains is as rare as the grains.
     */
    public double contrast() {
        return Math.min(1, Math.sqrt(dark / mean * diffracted));
    }
}
