package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.CsvFile;
import sunbeam.acceptance.NpyImage;
import sunbeam.acceptance.Reflectance;
import sunbeam.acceptance.Workplace;

/**
 * Compares colors of built-in patches with those of method {@code reference} in the test resources: pixels of maps under one light, and
 * lists of directions under many.
 */
class BuiltInPatchesTest {
    private static final int SIDE = 48;
    private static final double TOLERANCE = 1e-2;
    // The tolerance is promised for power above this (docs/accuracy-and-speed.md).
    private static final double DARKEST = 1e-9;

    @TempDir
    static Path root;

    private static Workplace workplace;
    private static final List<Reference> REFERENCES = new ArrayList<>();

    /** A direction pair and its X, Y, Z of relative radiance; column and row of its pixel in a map, -1 without one. */
    private record Reference(String surface, int column, int row, double[] angles, double[] xyz) {
        static Reference parse(String line) {
            String[] cells = line.split(",", -1);
            double[] numbers = Arrays.stream(cells)
                    .skip(2)
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            return new Reference(
                    cells[0] + " " + cells[1],
                    (int) numbers[0],
                    (int) numbers[1],
                    Arrays.copyOfRange(numbers, 2, 6),
                    Arrays.copyOfRange(numbers, 6, 9));
        }

        boolean isOfMap() {
            return column >= 0;
        }
    }

    @BeforeAll
    static void read() throws IOException {
        workplace = Workplace.in(root);
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                BuiltInPatchesTest.class.getResourceAsStream("/sunbeam/acceptance/contract/built-in-patches.csv"),
                StandardCharsets.UTF_8))) {
            lines.lines().skip(1).map(Reference::parse).forEach(REFERENCES::add);
        }
    }

    private static List<Reference> of(String patch, String average) {
        return REFERENCES.stream()
                .filter(one -> one.surface().equals(patch + " " + average))
                .toList();
    }

    private static List<String> options(String average, String method) {
        return List.of(
                "--average", average, "--method", method, "--coherence-length", "12um", "--tolerance", "" + TOLERANCE);
    }

    private static void assertWithinTolerance(List<double[]> found, List<double[]> exact) {
        List<Double> errors = new ArrayList<>();
        for (int i = 0; i < exact.size(); i++) {
            double largest = Arrays.stream(exact.get(i)).max().orElseThrow();
            double difference = 0;
            for (int c = 0; c < 3; c++) {
                difference = Math.max(difference, Math.abs(found.get(i)[c] - exact.get(i)[c]));
            }
            if (largest > DARKEST) {
                errors.add(difference / largest);
            }
        }
        errors.sort(null);
        assertThat(errors).as("directions with light").hasSizeGreaterThan(4);
        assertThat(errors.get(errors.size() / 2)).as("median").isLessThan(TOLERANCE);
        // Promised for 95 %: here all but the largest.
        assertThat(errors.get(errors.size() - 2)).as("all but one").isLessThan(3 * TOLERANCE);
    }

    @ParameterizedTest
    @CsvSource({
        "blaze, coherent, full",
        "blaze, coherent, table",
        "blaze, ensemble, full",
        "blaze, ensemble, table",
        "sinusoid, coherent, table",
        "sinusoid, ensemble, full",
        "lamellar, coherent, full",
        "lamellar, ensemble, table",
        "disc, coherent, full",
        "elaphe-like, coherent, full",
    })
    void mapsAreTheReferenceWithinTheTolerance(String patch, String average, String method) throws IOException {
        List<String> words = new ArrayList<>(List.of("brdf-map", "--patch", patch, "--theta-i", "20", "--force"));
        words.addAll(List.of("--size", "" + SIDE, "--output", "map.png", "--linear", "map.npy"));
        words.addAll(options(average, method));
        workplace.succeedHere(words.toArray(String[]::new));
        NpyImage map = NpyImage.read(workplace.resolve("map.npy"), SIDE);

        List<Reference> pixels =
                of(patch, average).stream().filter(Reference::isOfMap).toList();
        assertWithinTolerance(
                pixels.stream()
                        .map(one -> new double[] {
                            map.at(one.row(), one.column(), 0),
                            map.at(one.row(), one.column(), 1),
                            map.at(one.row(), one.column(), 2)
                        })
                        .toList(),
                pixels.stream().map(Reference::xyz).toList());
    }

    @ParameterizedTest
    @CsvSource({
        "blaze, coherent, full",
        "blaze, ensemble, table",
        "sinusoid, coherent, table",
        "sinusoid, ensemble, full",
        "lamellar, coherent, table",
        "lamellar, ensemble, table",
    })
    void listsUnderAllLightsAreTheReferenceWithinTheTolerance(String patch, String average, String method)
            throws Exception {
        List<Reference> directions = of(patch, average);
        CsvFile list = new CsvFile(
                List.of("theta_i", "phi_i", "theta_r", "phi_r"),
                directions.stream().map(Reference::angles).toList());

        CsvFile found =
                Reflectance.of(workplace, patch, list, options(average, method).toArray(String[]::new));

        List<double[]> colors = new ArrayList<>();
        for (int row = 0; row < found.size(); row++) {
            double gain = found.at(row, "gain");
            colors.add(new double[] {gain * found.at(row, "X"), gain * found.at(row, "Y"), gain * found.at(row, "Z")});
        }
        assertWithinTolerance(colors, directions.stream().map(Reference::xyz).toList());
    }
}
