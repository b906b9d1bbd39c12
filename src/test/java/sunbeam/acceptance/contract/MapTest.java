package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.NpyImage;
import sunbeam.acceptance.Workplace;

/** Linear maps: their shape, and their values against direct sums over the surface. */
class MapTest {
    // The promise is made where there is light.
    private static final double LEAST = 1e-9;

    @TempDir
    static Path root;

    private static Workplace workplace;

    /** A rough surface, which scatters everywhere. */
    @BeforeAll
    static void layOut() throws Exception {
        workplace = Workplace.in(root);
        SplittableRandom random = new SplittableRandom(11);
        Images.grey(workplace.resolve("rough.png"), 40, 32, (column, row) -> random.nextInt(256));
    }

    private static NpyImage map(String name, String patch, int side, String... more) throws Exception {
        List<String> words = new ArrayList<>(List.of("brdf-map", "--size", Integer.toString(side), "--force"));
        words.addAll(List.of(("--patch " + patch).split(" ", -1)));
        words.addAll(List.of("--output", name + ".png", "--linear", name + ".npy"));
        words.addAll(List.of(more));
        workplace.succeedHere(words.toArray(String[]::new));
        return NpyImage.read(workplace.resolve(name + ".npy"), side);
    }

    @ParameterizedTest
    @CsvSource({
        "full, coherent, blaze",
        "full, coherent, rough",
        "full, ensemble, rough",
        "table, coherent, rough",
        "table, ensemble, rough"
    })
    void coloursAreTheReferencesWithinTheTolerance(String method, String average, String patch) throws Exception {
        double tolerance = 1e-2;
        // Odd, so that the plane of a grating's orders is a row of pixels.
        int side = 11;
        String surface = patch.equals("rough") ? "rough.png --width 2um --max-height 150nm" : patch;
        String[] same = {"--theta-i=20", "--coherence-length=8um", "--average=" + average};

        NpyImage exact = map("exact", surface + " --method reference", side, same);
        NpyImage drawn = map("drawn", surface + " --method " + method + " --tolerance " + tolerance, side, same);

        List<Double> errors = new ArrayList<>();
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double largest = 0;
                double difference = 0;
                for (int channel = 0; channel < 3 && exact.inDisc(row, column); channel++) {
                    double value = exact.at(row, column, channel);
                    largest = Math.max(largest, value);
                    difference = Math.max(difference, Math.abs(drawn.at(row, column, channel) - value));
                }
                if (largest > LEAST) {
                    errors.add(difference / largest);
                }
            }
        }
        Collections.sort(errors);
        assertThat(errors).as("pixels with light").hasSizeGreaterThan(5);
        assertThat(errors.get(errors.size() / 2)).as("median").isLessThan(tolerance);
        assertThat(errors.get((int) (0.95 * (errors.size() - 1)))).as("95 %%").isLessThan(3 * tolerance);
    }

    @Test
    void theLinearMapHasItsDocumentedShapeAndNoNumbersOutsideTheDisc() throws Exception {
        int side = 33;

        NpyImage map = map("map", "blaze", side);

        assertThat(map.header()).contains("'descr': '<f4'", "'fortran_order': False", "'shape': (33, 33, 3)");
        assertThat(map.values()).hasSize(side * side * 3);
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                for (int channel = 0; channel < 3; channel++) {
                    float value = map.at(row, column, channel);
                    assertThat(Float.isFinite(value))
                            .as("row %d, column %d: %s", row, column, value)
                            .isEqualTo(map.inDisc(row, column));
                    assertThat(value < 0).isFalse();
                }
            }
        }
    }
}
