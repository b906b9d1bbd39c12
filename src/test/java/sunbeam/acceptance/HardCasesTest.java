package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tolerance of method {@code full} on difficult surfaces and directions: tails of orders, weak orders, steps, dust, reliefs of a few
 * nanometers and of micrometers, windows of 1 um and 1 mm, grazing light.
 */
class HardCasesTest {
    // The tolerance is promised for power above this.
    private static final double LEAST_POWER = 1e-9;

    @TempDir
    static Path root;

    private static Workplace workplace;

    /** Surface with the options of its light. */
    record HardCase(String name, String patch, List<String> options) {
        @Override
        public String toString() {
            return name;
        }
    }

    @BeforeAll
    static void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    static Stream<HardCase> cases() throws IOException {
        Path index = SharedData.hardCase("index.csv");
        return Files.readAllLines(index).stream()
                .skip(1)
                .map(line -> line.split(",", -1))
                .map(cells -> new HardCase(cells[0], cells[1], words(cells[2])));
    }

    static Stream<HardCase> coarselyPlanned() throws IOException {
        return cases().filter(
                        hard -> List.of("grazing_rms150_ens", "lamellar_10um").contains(hard.name()));
    }

    private static List<String> words(String text) {
        return Arrays.stream(text.split(" ")).filter(word -> !word.isEmpty()).toList();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void theStandardToleranceIsKept(HardCase hard) throws Exception {
        assertToleranceKept(1e-3, hard);
    }

    /** A coarse tolerance makes coarse plans, with a basis of few functions and few wavelengths. */
    @ParameterizedTest
    @MethodSource("coarselyPlanned")
    void aCoarseToleranceIsKept(HardCase hard) throws Exception {
        assertToleranceKept(1e-2, hard);
    }

    /** Asserts the promise: median error at most the tolerance, 95th percentile at most three times the tolerance. */
    private static void assertToleranceKept(double tolerance, HardCase hard) throws Exception {
        Path folder = SharedData.hardCase(hard.name());
        String patch =
                hard.patch().endsWith(".json") ? folder.resolve(hard.patch()).toString() : hard.patch();
        CsvFile exact = CsvFile.read(folder.resolve("in.csv"));
        List<String> options = new ArrayList<>(hard.options());
        options.addAll(List.of("--tolerance", Double.toString(tolerance)));

        CsvFile ours = Reflectance.of(workplace, patch, exact, options.toArray(String[]::new));

        int compared = 0;
        for (List<String> columns : List.of(List.of("power"), List.of("power_ensemble"), List.of("X", "Y", "Z"))) {
            if (exact.header().contains("exact_" + columns.get(0))) {
                compared++;
                double[] errors = IntStream.range(0, exact.size())
                        .filter(row -> Math.max(largest(exact, "exact_", columns, row), largest(ours, "", columns, row))
                                > LEAST_POWER)
                        .mapToDouble(row -> error(exact, ours, columns, row))
                        .sorted()
                        .toArray();
                String what = Arrays.toString(errors) + " of " + columns;
                assertThat(errors).as(what).isNotEmpty();
                assertThat(errors[(errors.length - 1) / 2])
                        .as("median of " + what)
                        .isLessThanOrEqualTo(tolerance);
                assertThat(errors[(int) (0.95 * (errors.length - 1))])
                        .as("95th percentile of " + what)
                        .isLessThanOrEqualTo(3 * tolerance);
            }
        }
        assertThat(compared).isPositive();
    }

    private static double largest(CsvFile file, String prefix, List<String> columns, int row) {
        return columns.stream()
                .mapToDouble(column -> file.at(row, prefix + column))
                .max()
                .orElseThrow();
    }

    private static double error(CsvFile exact, CsvFile ours, List<String> columns, int row) {
        double difference = columns.stream()
                .mapToDouble(column -> Math.abs(ours.at(row, column) - exact.at(row, "exact_" + column)))
                .max()
                .orElseThrow();
        return difference / Math.max(LEAST_POWER, largest(exact, "exact_", columns, row));
    }
}
