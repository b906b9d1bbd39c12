package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.optics.HeightMap;

class BuiltInPatchesTest {
    /** A quarter of the shortest wavelength: at grazing light and view a phase of pi between two samples. */
    private static final double COARSEST_PITCH = 380e-9 / 4;

    static Stream<String> names() {
        return BuiltInPatches.names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void isFineEnoughForVisibleLight(String name) {
        HeightMap patch = BuiltInPatches.generate(name);
        assertThat(patch.pitchX()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(patch.pitchY()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(Arrays.stream(patch.heights()).allMatch(Double::isFinite)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinusoid", "disc", "bumps", "elaphe-like", "xenopeltis-like"})
    void tilesWithoutASeam(String name) {
        HeightMap patch = BuiltInPatches.generate(name);
        int columns = patch.columns();
        int rows = patch.rows();
        double[] across = IntStream.range(0, columns)
                .mapToDouble(c -> rmsStep(rows, i -> patch.at((c + 1) % columns, i) - patch.at(c, i)))
                .toArray();
        double[] down = IntStream.range(0, rows)
                .mapToDouble(r -> rmsStep(columns, i -> patch.at(i, (r + 1) % rows) - patch.at(i, r)))
                .toArray();
        // The sinusoid's steps beside the seam are equal but for rounding.
        assertThat(across[columns - 1]).isLessThanOrEqualTo(greatestInside(across) * (1 + 1e-9));
        assertThat(down[rows - 1]).isLessThanOrEqualTo(greatestInside(down) * (1 + 1e-9));
    }

    private static double rmsStep(int count, IntToDoubleFunction step) {
        return Math.sqrt(IntStream.range(0, count)
                .mapToDouble(step)
                .map(value -> value * value)
                .average()
                .orElseThrow());
    }

    private static double greatestInside(double[] steps) {
        return IntStream.range(0, steps.length - 1)
                .mapToDouble(i -> steps[i])
                .max()
                .orElseThrow();
    }

    /** Rounding of sums over a few thousand heights, in square meters against mean squares of 1e-15. */
    private static final double ROUNDING = 1e-26;

    @Test
    void blazeRisesTowardsPlusXOverOnePeriod() {
        HeightMap blaze = BuiltInPatches.generate("blaze");
        assertThat(blaze.width()).isCloseTo(2.5e-6, within(1e-18));
        double step = 250e-9 / blaze.columns();
        for (int row = 0; row < blaze.rows(); row++) {
            for (int column = 1; column < blaze.columns(); column++) {
                // Equal steps but for rounding.
                assertThat(blaze.at(column, row) - blaze.at(column - 1, row)).isCloseTo(step, within(1e-20));
            }
        }
        // Mid-interval samples miss half a step at either end.
        assertThat(blaze.relief()).isCloseTo(250e-9 - step, within(1e-20));
    }

    @Test
    void sinusoidHasOneFrequencyOnly() {
        HeightMap sinusoid = BuiltInPatches.generate("sinusoid");
        Spectrum spectrum = new Spectrum(sinusoid);
        double amplitude = 100e-9;
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) == 1 && q == 0))
                .isCloseTo(amplitude * amplitude / 2, within(ROUNDING));
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) != 1 || q != 0)).isLessThan(ROUNDING);
    }

    @Test
    void lamellarHasTwoHeightsAndNoEvenOrders() {
        HeightMap lamellar = BuiltInPatches.generate("lamellar");
        assertThat(lamellar.heights()).containsOnly(0, 137.5e-9);
        long ridge = IntStream.range(0, lamellar.columns())
                .filter(column -> lamellar.at(column, 0) > 0)
                .count();
        assertThat(ridge).isEqualTo(lamellar.columns() / 2);
        assertThat(new Spectrum(lamellar).meanSquare((p, q) -> p % 2 == 0)).isLessThan(ROUNDING);
    }
}
