package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.optics.HeightMap;

class BuiltInPatchesTest {
    /** A quarter of the shortest wavelength: at grazing light and view a phase of pi between two samples. */
    private static final double COARSEST_PITCH = 380e-9 / 4;

    /** The sinusoid's steps beside the seam are equal but for rounding. */
    private static final double ROUNDING = 1 + 1e-9;

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
        assertThat(across[columns - 1]).isLessThanOrEqualTo(greatestInside(across) * ROUNDING);
        assertThat(down[rows - 1]).isLessThanOrEqualTo(greatestInside(down) * ROUNDING);
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
}
