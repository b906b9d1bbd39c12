package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.patch.HeightMap;

class FewPeriodsTest {
    private static final int SAMPLES = 96;
    private static final double PITCH = 100e-9;
    // With -Dsunbeam.draws=60: none of 60 surfaces each, and of 1200 profiles 0, 1 and 2.
    private static final int DRAWS = Integer.getInteger("sunbeam.draws", 1);
    private static final double LENGTH = SAMPLES * PITCH;

    private static HeightMap scan(DoubleBinaryOperator height) {
        return Surfaces.of(SAMPLES, SAMPLES, PITCH, height);
    }

    private static double part(double turns) {
        return turns - Math.floor(turns);
    }

    @ParameterizedTest
    @CsvSource({"2.7, 0, 0.5", "3.5, 0, 0.3", "3.5, 90, 0.5", "3.1, 160, 0.5", "3.9, 35, 0.2"})
    void groovesThatAreSeenThreeTimesAreTold(double count, double degrees, double width) {
        SplittableRandom random = new SplittableRandom(3);
        double angle = Math.toRadians(degrees);
        double along = LENGTH / Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
        double period = along / count;
        FewPeriods told = FewPeriods.in(scan((x, y) ->
                        1e-7 * (part((x * Math.cos(angle) + y * Math.sin(angle)) / period + 0.2) < width ? 1 : 0)
                                + 1e-8 * random.nextGaussian()
                                + 0.02 * x))
                .orElseThrow();
        // Two digits are printed; walls fall between samples, of 24 to 36 a period.
        assertThat(told.period()).isCloseTo(period, within(0.05 * period));
        assertThat(told.count()).isCloseTo(count, within(0.05 * count));
        // 6 degrees: walls between samples are stairs.
        assertThat(Math.cos(2 * (told.direction() - angle))).isGreaterThan(Math.cos(2 * Math.toRadians(6)));
    }

    /** A wave whose crests grow without end or whose gaps differ is none that a larger scan is sure to show. */
    @Test
    void whatNeverRepeatsIsNoWave() {
        assertThat(FewPeriods.in(scan((x, y) -> 1e-7 * Math.sin(2e13 * x * x)))).isEmpty();
        assertThat(FewPeriods.in(scan((x, y) -> x > 0.4 * LENGTH ? 1e-7 : 0))).isEmpty();
        assertThat(FewPeriods.in(scan((x, y) -> 5e3 * (x - 0.5 * LENGTH) * (x - 0.5 * LENGTH))))
                .isEmpty();
        assertThat(FewPeriods.in(scan((x, y) -> 0))).isEmpty();
        assertThat(FewPeriods.in(Surfaces.of(200, 1, PITCH, (x, y) -> Math.sin(x * 1e6))))
                .isEmpty();
    }

    /** Waves of random phases, in all directions or along x alone, whose amplitudes fall with a power of the frequency. */
    @ParameterizedTest
    @CsvSource({"0, false", "1, false", "1.5, false", "2, false", "0, true", "1, true", "2, true"})
    void noiseAndFractalsAreNoWaves(double exponent, boolean alongX) {
        int told = 0;
        for (int seed = 0; seed < (alongX ? 20 : 1) * DRAWS; seed++) {
            told += FewPeriods.in(random(exponent, alongX, seed)).isPresent() ? 1 : 0;
        }
        assertThat(told).isZero();
    }

    private static HeightMap random(double exponent, boolean alongX, int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int most = 12;
        double[] sums = new double[SAMPLES * SAMPLES];
        for (int fy = alongX ? 0 : -most; fy <= (alongX ? 0 : most); fy++) {
            for (int fx = 0; fx <= most; fx++) {
                double frequency = Math.hypot(fx, fy);
                if (frequency > 0) {
                    double amplitude = random.nextGaussian() * Math.pow(frequency, -exponent);
                    double phase = 2 * Math.PI * random.nextDouble();
                    double shift = random.nextDouble() - 0.5;
                    for (int i = 0; i < sums.length; i++) {
                        double turns = (fx + (alongX ? shift : 0)) * (i % SAMPLES) + fy * (i / SAMPLES);
                        sums[i] += amplitude * Math.cos(2 * Math.PI * turns / SAMPLES + phase);
                    }
                }
            }
        }
        return new HeightMap(SAMPLES, SAMPLES, PITCH, PITCH, sums);
    }
}
