package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.patch.HeightMap;

final class PeriodFinderTest {
    private static final double PITCH = 130e-9;
    private static final int SAMPLES = 400;
    // Deviation of a sunlit coherence area's spectrum, cycles per metre.
    private static final double SIGMA = 9794;

    private static double wave(double x, double y, double period, double degrees) {
        double angle = Math.toRadians(degrees);
        return Math.sin(2 * Math.PI / period * (x * Math.cos(angle) + y * Math.sin(angle)));
    }

    private static HeightMap noise(int columns, int rows, double pitch, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return Surfaces.of(columns, rows, pitch, (x, y) -> 10e-9 * random.nextGaussian());
    }

    @ParameterizedTest
    @CsvSource({"1370, 0", "1370, 17", "900, 90", "2210, 133", "523, 179"})
    void aWaveInNoiseIsFoundWithItsPeriodAndDirection(double nanometres, double degrees) {
        SplittableRandom random = new SplittableRandom(1);
        HeightMap map = Surfaces.of(
                SAMPLES,
                320,
                PITCH,
                (x, y) -> 30e-9 * wave(x, y, nanometres * 1e-9, degrees) + 10e-9 * random.nextGaussian());
        Periodicity found = new PeriodFinder(map).all();
        assertThat(found.peaks()).hasSize(1);
        SpectrumPeak peak = found.peaks().get(0);
        // A twentieth of a bin, of the 20 to 100 periods that fit into the patch.
        assertThat(peak.period() * 1e9).isCloseTo(nanometres, within(nanometres * nanometres * 1e-9 / 50e-6 / 20));
        assertThat(Math.toDegrees(peak.direction())).isCloseTo(degrees, within(0.15));
        // 30 nm / sqrt 2, and what noise lies in the same bins.
        assertThat(peak.rms()).isCloseTo(21.2e-9, within(0.3e-9));
    }

    @Test
    void aRegularityIsSeenAlongItsOwnDirectionOnly() {
        HeightMap map = Surfaces.of(SAMPLES, SAMPLES, PITCH, (x, y) -> 30e-9 * wave(x, y, 1.1e-6, 25));
        PeriodFinder finder = new PeriodFinder(map);
        Periodicity along = finder.along(Math.toRadians(25), SIGMA);
        // Along a line maxima are taken on half bins: 0.5 / 47 of the period.
        assertThat(along.peaks().get(0).period()).isCloseTo(1.1e-6, within(12e-9));
        for (double degrees : new double[] {0, 10, 35, 60, 115}) {
            assertThat(finder.along(Math.toRadians(degrees), SIGMA).found())
                    .as("%s degrees", degrees)
                    .isFalse();
        }
    }

    @Test
    void twoRegularitiesAreToldApartAndTheHigherOneComesFirst() {
        HeightMap map = Surfaces.of(
                SAMPLES, SAMPLES, PITCH, (x, y) -> 30e-9 * wave(x, y, 1e-6, 0) + 20e-9 * wave(x, y, 1.35e-6, 0));
        Periodicity found = new PeriodFinder(map).all();
        assertThat(found.peaks())
                .extracting(peak -> Math.rint(peak.period() * 1e9))
                .containsExactly(1000.0, 1350.0);
    }

    /** Of waves of one height only the strongest was told, since noise in the average made the others "stronger". */
    @Test
    void allWavesOfALatticeAreTold() {
        SplittableRandom random = new SplittableRandom(1);
        HeightMap map = Surfaces.of(
                SAMPLES,
                SAMPLES,
                PITCH,
                (x, y) -> 20e-9 * (wave(x, y, 1e-6, 11) + wave(x, y, 1e-6, 71) + wave(x, y, 1e-6, 131))
                        + 1e-9 * random.nextGaussian());
        Periodicity found = new PeriodFinder(map, false).all();
        // To a tenth of a degree: a hundredth of a bin.
        assertThat(found.peaks())
                .extracting(peak -> Math.rint(Math.toDegrees(peak.direction())))
                .containsExactlyInAnyOrder(11.0, 71.0, 131.0);
        assertThat(found.peaks())
                .extracting(peak -> Math.rint(peak.period() * 1e9))
                .containsOnly(1000.0);
    }

    /** The power of narrow dots lies in hundreds of lines, none of which holds much of it. */
    @ParameterizedTest
    @CsvSource({"1200, 1200, 72", "1350, 900, 90"})
    void aLatticeOfNarrowDotsHasThePeriodsOfItsRows(double first, double second, double deviation) {
        SplittableRandom random = new SplittableRandom(1);
        HeightMap map = Surfaces.of(256, 256, 20e-6 / 256, (x, y) -> {
            double dx = Math.IEEEremainder(x * 1e9, second) / deviation;
            double dy = Math.IEEEremainder(y * 1e9, first) / deviation;
            return 60e-9 * Math.exp(-0.5 * (dx * dx + dy * dy)) + 2e-9 * random.nextGaussian();
        });
        // A hundredth of a bin.
        assertThat(new PeriodFinder(map).all().peaks().subList(0, 2))
                .extracting(peak -> peak.period() * 1e9)
                .allSatisfy(period -> assertThat(Math.min(Math.abs(period - first), Math.abs(period - second)))
                        .isLessThan(1))
                .anySatisfy(period -> assertThat(period).isCloseTo(first, within(1.0)))
                .anySatisfy(period -> assertThat(period).isCloseTo(second, within(1.0)));
    }

    @Test
    void overtonesAreNotListed() {
        // 20 samples a tooth: steps of the sampling stay whole.
        HeightMap map =
                Surfaces.of(SAMPLES, SAMPLES, PITCH, (x, y) -> 100e-9 * (x / 2.6e-6 - Math.floor(x / 2.6e-6 + 1e-9)));
        Periodicity found = new PeriodFinder(map).all();
        assertThat(found.peaks())
                .extracting(peak -> Math.rint(peak.period() * 1e9))
                .containsExactly(2600.0);
    }

    @Test
    void aStrayingRegularityIsOnePeakAtItsMeanPeriod() {
        SplittableRandom random = new SplittableRandom(3);
        double[] heights = new double[500];
        // Ridges whose distances scatter independently by 12 %: order is lost over some ten of them.
        for (double position = 0; position < 500; position += 8 * (1 + 0.12 * random.nextGaussian())) {
            for (int i = 0; i < 500; i++) {
                heights[i] += 50e-9 * Math.exp(-0.5 * Math.pow((i - position) / 1.7, 2));
            }
        }
        HeightMap map = Surfaces.of(500, 200, PITCH, (x, y) -> heights[(int) Math.rint(x / PITCH)]);
        Periodicity found = new PeriodFinder(map).all();
        // 62 ridges at 12 % each: their mean distance is known to 1.5 %; the spectrum's peak to a bin or two, 3 %.
        assertThat(found.peaks().get(0).period()).isCloseTo(8 * PITCH, within(0.08 * 8 * PITCH));
        assertThat(Math.sin(found.peaks().get(0).direction())).isCloseTo(0, within(0.02));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void noiseHasNoPeriodInAnyDirection(long seed) {
        PeriodFinder finder = new PeriodFinder(noise(SAMPLES, SAMPLES, PITCH, seed));
        Periodicity all = finder.all();
        assertThat(all.found()).isFalse();
        // The margin to the threshold of 5 that its comment claims.
        assertThat(all.figure()).isBetween(1.0, 2.0);
        for (int degrees = 0; degrees < 180; degrees += 20) {
            assertThat(finder.along(Math.toRadians(degrees), SIGMA).figure()).isLessThan(3.5);
        }
        assertThat(all.describeFigure()).contains("times above its surroundings", "5.00 are needed");
    }

    @Test
    void noiseOfASingleRowHasNoPeriod() {
        for (long seed = 0; seed < 60; seed++) {
            Periodicity found = new PeriodFinder(noise(1500, 1, 45e-9, seed)).all();
            assertThat(found.found()).as("seed %s: %s", seed, found.figure()).isFalse();
        }
    }

    @Test
    void wavinessHasNoPeriod() {
        SplittableRandom random = new SplittableRandom(9);
        double[] walk = new double[1200];
        for (int i = 1; i < walk.length; i++) {
            walk[i] = walk[i - 1] + 1e-9 * random.nextGaussian();
        }
        HeightMap map = Surfaces.of(1200, 100, 50e-9, (x, y) -> walk[(int) Math.rint(x / 50e-9)]);
        assertThat(new PeriodFinder(map).all().found()).isFalse();
    }

    @Test
    void aFlatPatchHasNoPeriodAndAFigureOfZero() {
        Periodicity found = new PeriodFinder(Surfaces.of(64, 64, PITCH, (x, y) -> 1e-3)).all();
        assertThat(found.found()).isFalse();
        assertThat(found.figure()).isLessThan(1e-6);
    }

    @Test
    void oneSampleHasNoPeriod() {
        assertThat(new PeriodFinder(Surfaces.of(1, 1, PITCH, (x, y) -> 5e-9))
                        .all()
                        .found())
                .isFalse();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 40})
    void oneToothOfABlazedGratingIsItsPeriod(int rows) {
        HeightMap map = Surfaces.of(100, rows, 25e-9, (x, y) -> 0.1 * x);
        PeriodFinder finder = new PeriodFinder(map);
        Periodicity found = finder.all();
        assertThat(found.edges()).isEqualTo(HeightSpectrum.Edges.PERIODIC);
        assertThat(found.peaks().get(0).period()).isCloseTo(2.5e-6, within(1e-15));
        assertThat(found.peaks().get(0).direction()).isZero();
        // First order of a sawtooth, 6 / pi^2; 100 samples change it by less than 1/1000.
        assertThat(found.figure()).isCloseTo(0.608, within(0.001));
        assertThat(finder.along(Math.PI / 2, SIGMA).found()).isFalse();
    }

    @Test
    void aSmallPatchOfNoiseHasNoPeriodThoughItRepeats() {
        Periodicity found = new PeriodFinder(noise(100, 100, 100e-9, 5)).all();
        assertThat(found.found()).isFalse();
        assertThat(found.describeFigure()).contains("% of the heights' variance");
    }
}
