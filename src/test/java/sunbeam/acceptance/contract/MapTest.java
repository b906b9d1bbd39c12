package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.CsvFile;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.NpyImage;
import sunbeam.acceptance.Reflectance;
import sunbeam.acceptance.Workplace;

/** Shape of linear maps, and their values compared with direct sums over the surface. */
class MapTest {
    // The tolerance is promised for power above this.
    private static final double LEAST = 1e-9;
    private static final double THETA_I = 20;

    @TempDir
    static Path root;

    private static Workplace workplace;

    /** Makes a rough surface, which scatters in all directions. */
    @BeforeAll
    static void layOut() throws Exception {
        workplace = Workplace.in(root);
        SplittableRandom random = new SplittableRandom(11);
        Images.gray(workplace.resolve("rough.png"), 40, 32, (column, row) -> random.nextInt(256));
    }

    private static NpyImage map(String name, String patch, int side, String... more) throws Exception {
        List<String> words = new ArrayList<>(List.of("brdf-map", "--size", Integer.toString(side), "--force"));
        words.addAll(List.of("--patch", patch, "--output", name + ".png", "--linear", name + ".npy"));
        words.addAll(List.of(more));
        workplace.succeedHere(words.toArray(String[]::new));
        return NpyImage.read(workplace.resolve(name + ".npy"), side);
    }

    /** Returns the directions of a map's pixels, row by row, with their colors by {@code reflectance}. */
    private static CsvFile exact(NpyImage map, String patch, String... more) throws Exception {
        List<double[]> directions = new ArrayList<>();
        for (int row = 0; row < map.side(); row++) {
            for (int column = 0; column < map.side(); column++) {
                if (map.inDisc(row, column)) {
                    double x = map.place(column);
                    double y = -map.place(row);
                    directions.add(new double[] {
                        THETA_I, 0, Math.toDegrees(Math.asin(Math.hypot(x, y))), Math.toDegrees(Math.atan2(y, x))
                    });
                }
            }
        }
        CsvFile list = new CsvFile(List.of("theta_i", "phi_i", "theta_r", "phi_r"), directions);
        String[] all = Stream.concat(Stream.of("--method", "reference"), Stream.of(more))
                .toArray(String[]::new);
        return Reflectance.of(workplace, patch, list, all);
    }

    @ParameterizedTest
    @CsvSource({"full, coherent", "full, ensemble", "table, coherent", "table, ensemble"})
    void colorsAreTheReferencesWithinTheTolerance(String method, String average) throws Exception {
        double tolerance = 1e-2;
        String surface = "--periodic --width 4um --max-height 150nm --coherence-length 8um --average " + average;
        String[] same = surface.split(" ", -1);
        String[] asked = (surface + " --theta-i " + THETA_I + " --method " + method + " --tolerance " + tolerance)
                .split(" ", -1);

        NpyImage drawn = map("drawn", "rough.png", 9, asked);
        CsvFile exact = exact(drawn, "rough.png", same);

        List<Double> errors = new ArrayList<>();
        int pixel = 0;
        for (int row = 0; row < drawn.side(); row++) {
            for (int column = 0; column < drawn.side(); column++) {
                if (!drawn.inDisc(row, column)) {
                    continue;
                }
                double largest = 0;
                double difference = 0;
                for (int channel = 0; channel < 3; channel++) {
                    double value = exact.at(pixel, "gain")
                            * exact.at(pixel, List.of("X", "Y", "Z").get(channel));
                    largest = Math.max(largest, value);
                    difference = Math.max(difference, Math.abs(drawn.at(row, column, channel) - value));
                }
                pixel++;
                if (largest > LEAST) {
                    errors.add(difference / largest);
                }
            }
        }
        Collections.sort(errors);
        assertThat(errors).as("pixels with light").hasSizeGreaterThan(20);
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
