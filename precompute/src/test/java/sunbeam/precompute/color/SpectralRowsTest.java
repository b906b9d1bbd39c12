package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.NavigableMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lights tabulated in steps of 1 to 20 nm, equal or not: smooth spectra are interpolated smoothly, lines stay lines. */
class SpectralRowsTest {
    private static Illuminant sampled(double[] rows, DoubleUnaryOperator power) {
        NavigableMap<Double, Double> table = new TreeMap<>();
        Arrays.stream(rows).forEach(row -> table.put(row, power.applyAsDouble(row)));
        return Illuminant.ofRows("lamp", table);
    }

    private static double[] every(double step) {
        return IntStream.rangeClosed(0, (int) Math.ceil(400 / step))
                .mapToDouble(i -> 380 + i * step)
                .toArray();
    }

    /** Steps from 0.6 to 1.4 times the mean, at least 1 nm. */
    private static double[] unequal(double step) {
        SplittableRandom random = new SplittableRandom(7);
        double[] rows = every(step);
        for (int i = 1; i < rows.length - 1; i++) {
            rows[i] += 0.2 * step * (2 * random.nextDouble() - 1);
        }
        return rows;
    }

    private static double gauss(double distance, double deviation) {
        return Math.exp(-0.5 * Math.pow(distance / deviation, 2));
    }

    /** White LED: a blue chip of 24 nm full width at half maximum, and its phosphor. */
    private static double whiteLed(double nanometers) {
        return gauss(nanometers - 452.3, 10.2) + 0.7 * gauss(nanometers - 575, 58);
    }

    private static double largestError(Illuminant light, DoubleUnaryOperator power) {
        return IntStream.rangeClosed(0, Illuminant.LAST)
                .mapToDouble(i -> Math.abs(light.power()[i] - power.applyAsDouble(380.0 + i)))
                .max()
                .orElseThrow();
    }

    /** The shipped column was computed by another implementation of Sprague's polynomials (Python's colour-science). */
    @Test
    void ledsAreInterpolatedBySpraguesPolynomials() {
        Illuminant shipped = Illuminant.of("LED-B3");

        Illuminant resampled = sampled(every(5), row -> shipped.power()[(int) row - 380]);

        // Seven digits of powers up to 19.
        assertThat(resampled.power()).containsExactly(shipped.power(), within(1e-5));
        assertThat(resampled.isSmooth()).isTrue();
    }

    @Test
    void linesOfFluorescentLampsAreJoinedByLines() {
        Illuminant shipped = Illuminant.of("F11");

        Illuminant resampled = sampled(every(5), row -> shipped.power()[(int) row - 380]);

        // Rounding.
        assertThat(resampled.power()).containsExactly(shipped.power(), within(1e-12));
        assertThat(resampled.isSmooth()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"1, 1e-12", "2, 1e-4", "5, 2e-3", "10, 0.04"})
    void aWhiteLedInEqualOrUnequalStepsIsSmooth(double step, double error) {
        for (double[] rows : new double[][] {every(step), step > 1 ? unequal(step) : every(step)}) {
            Illuminant light = sampled(rows, SpectralRowsTest::whiteLed);
            // Chords err by 1 % in steps of 3 nm, 13 % in steps of 10 nm.
            assertThat(largestError(light, SpectralRowsTest::whiteLed)).isLessThan(error);
            assertThat(light.isSmooth()).isTrue();
        }
    }

    /** The method is exact to degree 4, and in the first and last two intervals, for which it adds rows, to degree 1. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 10, 20})
    void polynomialsAreInterpolatedExactly(double step) {
        DoubleUnaryOperator quartic = nanometers -> {
            double t = (nanometers - 560) / 200;
            return 3 + t * (1 + t * (-0.5 + t * (0.3 + 0.2 * t)));
        };
        Illuminant light = sampled(every(step), quartic);
        int end = (int) (2 * step);
        for (int i = end; i <= Illuminant.LAST - end; i++) {
            // Rounding.
            assertThat(light.power()[i]).isCloseTo(quartic.applyAsDouble(380.0 + i), within(1e-12));
        }
        DoubleUnaryOperator line = nanometers -> 3 + 1e-2 * nanometers;
        assertThat(largestError(sampled(every(step), line), line)).isLessThan(1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 5, 10, 20})
    void aLaserInOneRowIsATriangle(double step) {
        double line = 380 + step * Math.rint(160 / step);
        Illuminant laser = sampled(every(step), row -> row == line ? 1 : 0.02);

        assertThat(largestError(laser, at -> 0.02 + 0.98 * Math.max(0, 1 - Math.abs(at - line) / step)))
                // Rounding.
                .isLessThan(1e-12);
        assertThat(laser.isSmooth()).isFalse();
    }

    /** A peak between 380 nm and darkness: polynomials undershoot by 2 % of it. */
    @Test
    void noPowerIsNegativeAndDarknessStaysDark() {
        Illuminant light = sampled(every(5), row -> row > 600 ? 0 : gauss(row - 450, 8) + gauss(row - 600, 8));

        assertThat(Arrays.stream(light.power()).min().orElseThrow()).isEqualTo(0);
        assertThat(Arrays.copyOfRange(light.power(), 605 - 380, 401)).containsOnly(0);
    }
}
