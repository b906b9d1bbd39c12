package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.ScanFault;
import sunbeam.precompute.prepare.ScanFaults;

/** Verdicts of drawn surfaces beside their truth. {@link #main} counts larger numbers. */
class KnownSurfaceTest {
    // Of a period that is called probable.
    private static final double ABOUT = 0.1;
    private static final double NEAR = 0.02;

    enum Outcome {
        RIGHT,
        WEAK,
        MISSED,
        WRONG,
        FALSELY_PROBABLE,
        FALSELY_SURE
    }

    /** @param held whether the truth is in the interval; empty without one */
    private record Result(KnownSurface surface, Outcome outcome, Optional<Boolean> held, String sentence) {
        static Result of(KnownSurface surface) {
            Patch patch = patch(surface.map());
            GratingPeriod period = GratingPeriod.of(patch);
            Verdict verdict = Verdict.of(patch, period, 0, 0);
            boolean sure = period.isSure();
            Outcome outcome = switch (surface.kind().truth) {
                case GRATING, LATTICE -> ofOrder(surface, period, sure);
                case RING ->
                    sure
                            ? Outcome.FALSELY_SURE
                            : verdict.code() == Verdict.Code.ALL_DIRECTIONS ? Outcome.RIGHT : Outcome.WEAK;
                case FEW -> ofFew(surface, period);
                case NONE -> sure ? Outcome.FALSELY_SURE : period.isSeen() ? Outcome.FALSELY_PROBABLE : Outcome.RIGHT;
            };
            boolean told = sure && (outcome == Outcome.RIGHT || outcome == Outcome.WRONG);
            return new Result(
                    surface,
                    outcome,
                    Optional.of(isHeld(surface, period)).filter(held -> told && surface.periods().length > 0),
                    verdict.sentence());
        }

        private static Outcome ofFew(KnownSurface surface, GratingPeriod period) {
            if (period.isSeen()) {
                return isWithin(surface, period, ABOUT) ? Outcome.WEAK : Outcome.WRONG;
            }
            return period.certainty() == GratingPeriod.Certainty.TOO_LITTLE ? Outcome.RIGHT : Outcome.MISSED;
        }

        private static Outcome ofOrder(KnownSurface surface, GratingPeriod period, boolean sure) {
            if (!period.isSeen()) {
                return Outcome.MISSED;
            }
            if (sure && (isHeld(surface, period) || isWithin(surface, period, NEAR))) {
                boolean lattice = surface.kind() == KnownSurface.Kind.LATTICE;
                return lattice == period.isLattice() ? Outcome.RIGHT : Outcome.WEAK;
            }
            return isWithin(surface, period, ABOUT) ? Outcome.WEAK : Outcome.WRONG;
        }

        private static boolean isHeld(KnownSurface surface, GratingPeriod period) {
            return Arrays.stream(surface.periods()).anyMatch(truth -> period.low() <= truth && truth <= period.high());
        }

        private static boolean isWithin(KnownSurface surface, GratingPeriod period, double most) {
            return Arrays.stream(surface.periods()).anyMatch(truth -> Math.abs(period.period() / truth - 1) < most);
        }
    }

    private static Patch patch(HeightMap raw) {
        HeightMap map = Leveling.PLANE.apply(raw);
        List<ScanFault> faults = ScanFaults.in(raw, Optional.empty());
        return new Patch("drawn", map, map, "a test", List.of(), List.of(), List.of(), faults, Patch.Repetition.NONE);
    }

    private static List<Result> results(long first, int each, KnownSurface.Kind... kinds) {
        return Arrays.stream(kinds)
                .flatMap(kind -> LongStream.range(first, first + each).mapToObj(seed -> KnownSurface.draw(kind, seed)))
                .parallel()
                .map(Result::of)
                .toList();
    }

    /**
     * Three of each kind, of rates stated for many: clear gratings and lattices 97 % right or weak, 85 % right; without order 1 in 200 sure, 3 in
     * 100 probable; the truth in 95 % of the intervals. Of 30 clear ones at these rates, four or more are missed once in 80 such tests, eleven or
     * more not right once in 300; of 24 without order, two or more are sure once in 150 tests, four or more probable once in 200; of 27 intervals,
     * five or more miss the truth once in 100.
     */
    @Test
    void verdictsAgreeWithTheTruth() {
        List<Result> results = results(0, 3, KnownSurface.Kind.values());
        assertThat(results).hasSizeGreaterThan(56);
        List<Result> clear =
                results.stream().filter(result -> result.surface.clear()).toList();
        String words = String.join(
                "\n",
                results.stream()
                        .filter(result -> result.outcome != Outcome.RIGHT)
                        .map(result -> result.outcome + " " + result.surface.words() + ": " + result.sentence)
                        .toList());
        assertThat(count(clear, Outcome.MISSED) + count(clear, Outcome.WRONG))
                .as(words)
                .isLessThan(4);
        assertThat(clear.size() - count(clear, Outcome.RIGHT)).as(words).isLessThan(11);
        assertThat(count(results, Outcome.FALSELY_SURE)).as(words).isLessThan(2);
        assertThat(count(results, Outcome.FALSELY_PROBABLE)).as(words).isLessThan(4);
        assertThat(results.stream()
                        .filter(result -> result.held.equals(Optional.of(false)))
                        .count())
                .as(words)
                .isLessThan(5);
    }

    /** Of 12 surfaces at 97 % right or weak, two or more are missed once in 20 such tests. */
    @Test
    void terraceEdgesNeitherHideNorCrossLines() {
        List<Result> results = results(100, 12, KnownSurface.Kind.EDGES);
        assertThat(results.size() - count(results, Outcome.RIGHT)).isLessThan(2);
        assertThat(results)
                .filteredOn(result -> result.sentence.contains(", crossed"))
                .hasSizeLessThan(3);
    }

    /** Of noise with lines in one direction, these have by chance a peak far above what is beside it, or near the sampling frequency. */
    @ParameterizedTest
    @CsvSource({
        "RANDOM_PITS, 5008",
        "RANDOM_PITS, 20032",
        "RANDOM_PITS, 20092",
        "BRUSHED, 20077",
        "BUMPS, 20062",
        "BRUSHED, 20034"
    })
    void aHighPeakOfNoiseIsNotSure(KnownSurface.Kind kind, long seed) {
        GratingPeriod found =
                GratingPeriod.of(patch(KnownSurface.draw(kind, seed).map()));
        assertThat(found.isSure()).as(found.describe()).isFalse();
        boolean isRidgeOrAlias = kind == KnownSurface.Kind.BUMPS || found.wave().period() < 0.5e-6;
        assertThat(isRidgeOrAlias && found.isSeen()).as(found.describe()).isFalse();
    }

    @Test
    void fewPeriodsAreTooFewToJudge() {
        assertThat(results(100, 12, KnownSurface.Kind.FEW_PERIODS))
                .allSatisfy(
                        result -> assertThat(result.outcome).as(result.sentence).isIn(Outcome.RIGHT, Outcome.WEAK));
    }

    /** A wave of the amplitude that "no order" excludes is told where it is there; no more than twice the relief is excluded. */
    @Test
    void excludedWavesWouldBeSeen() {
        int tried = 0;
        int told = 0;
        for (long seed = 100; seed < 112; seed++) {
            KnownSurface.Kind kind = seed % 2 == 0 ? KnownSurface.Kind.ROUGH : KnownSurface.Kind.FRACTAL;
            HeightMap map = KnownSurface.draw(kind, seed).map();
            Optional<WaveLimit> limit = GratingPeriod.of(patch(map)).limit();
            if (limit.isPresent()) {
                WaveLimit waves = limit.get();
                assertThat(waves.amplitude()).isLessThan(2 * map.relief());
                double part = (seed - 100) / 11.0;
                double turns = 2 * Math.PI / (waves.shortest() * Math.pow(waves.longest() / waves.shortest(), part));
                double angle = 0.27 * seed;
                double[] heights = map.heights().clone();
                Arrays.setAll(
                        heights,
                        i -> heights[i]
                                + waves.amplitude()
                                        * Math.sin(turns
                                                * map.pitchX()
                                                * (Math.cos(angle) * (i % map.columns())
                                                        - Math.sin(angle) * Math.floorDiv(i, map.columns()))));
                tried++;
                told += GratingPeriod.of(patch(map.with(heights))).certainty() == GratingPeriod.Certainty.NONE ? 0 : 1;
            }
        }
        assertThat(tried).isGreaterThan(7);
        // At 95 % two are missed once in 10 such tests.
        assertThat(tried - told).isLessThan(2);
    }

    private static long count(List<Result> results, Outcome outcome) {
        return results.stream().filter(result -> result.outcome == outcome).count();
    }

    /** Arguments: the first seed and the number of surfaces of each kind. Prints what is not right, then counts. */
    public static void main(String[] arguments) {
        Map<String, Integer> counts = new HashMap<>();
        for (Result result :
                results(Long.parseLong(arguments[0]), Integer.parseInt(arguments[1]), KnownSurface.Kind.values())) {
            String kind = result.surface.kind() + (result.surface.clear() ? ", clear" : "");
            counts.merge(kind + ": " + result.outcome, 1, Integer::sum);
            result.held.ifPresent(held -> counts.merge("interval holds the truth: " + held, 1, Integer::sum));
            if (result.outcome != Outcome.RIGHT) {
                System.out.println(result.outcome + " " + result.surface.words() + ": " + result.sentence);
            }
        }
        counts.entrySet().stream().map(Object::toString).sorted().forEach(System.out::println);
    }
}
