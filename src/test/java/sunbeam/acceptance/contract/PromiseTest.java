package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.acceptance.CsvFile;
import sunbeam.acceptance.Reflectance;
import sunbeam.acceptance.SharedData;
import sunbeam.acceptance.Workplace;

/**
 * Tolerance of method {@code full} on random directions of measured patches, compared with an independent program: a median relative error
 * of at most the tolerance and a 95th percentile of at most three times it.
 */
class PromiseTest {
    // The tolerance is promised for power above this.
    private static final double LEAST_POWER = 1e-9;

    @TempDir
    static Path root;

    private static Workplace workplace;

    @BeforeAll
    static void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    @ParameterizedTest
    @CsvSource({"blaze, 1e-4", "elaphe, 1e-2", "xenopeltis, 1e-3"})
    void powerKeepsTheTolerance(String patch, double tolerance) throws Exception {
        CsvFile exact = SharedData.reference("power", patch);

        CsvFile ours = reflectance(patch, exact, tolerance);

        assertErrorsWithin(
                IntStream.range(0, exact.size())
                        .filter(row -> exact.at(row, "power") > LEAST_POWER)
                        .mapToDouble(row -> Math.abs(ours.at(row, "power") / exact.at(row, "power") - 1))
                        .sorted()
                        .toArray(),
                tolerance);
    }

    /** Uses the default tolerance, since the independent colors of sharp orders have errors of 1e-4. */
    @ParameterizedTest
    @ValueSource(strings = {"blaze", "elaphe"})
    void colorKeepsTheTolerance(String patch) throws Exception {
        double tolerance = 1e-3;
        CsvFile exact = SharedData.reference("xyz", patch);

        CsvFile ours = reflectance(patch, exact, tolerance);

        assertErrorsWithin(
                IntStream.range(0, exact.size())
                        .filter(row -> largest(exact, row) > LEAST_POWER)
                        .mapToDouble(row -> error(exact, ours, row))
                        .sorted()
                        .toArray(),
                tolerance);
    }

    /** Returns the largest difference of X, Y or Z relative to the largest of the three. */
    private static double error(CsvFile exact, CsvFile ours, int row) {
        List<String> columns = List.of("X", "Y", "Z");
        double difference = columns.stream()
                .mapToDouble(column -> Math.abs(ours.at(row, column) - exact.at(row, column)))
                .max()
                .orElseThrow();
        return difference / largest(exact, row);
    }

    private static double largest(CsvFile colors, int row) {
        return Math.max(colors.at(row, "X"), Math.max(colors.at(row, "Y"), colors.at(row, "Z")));
    }

    private static void assertErrorsWithin(double[] errors, double tolerance) {
        assertThat(errors).hasSizeGreaterThan(5);
        double median = errors[errors.length / 2];
        double high = errors[(int) Math.ceil(0.95 * (errors.length - 1))];
        System.out.printf(
                "tolerance %.0e: median %.1e, 95th percentile %.1e of %d directions%n",
                tolerance, median, high, errors.length);
        assertThat(median).as("median").isLessThanOrEqualTo(tolerance);
        assertThat(high).as("95th percentile").isLessThanOrEqualTo(3 * tolerance);
    }

    private static CsvFile reflectance(String patch, CsvFile directions, double tolerance) throws Exception {
        return Reflectance.of(
                workplace,
                SharedData.patch(patch).toString(),
                directions,
                "--average",
                "coherent",
                "--tolerance",
                Double.toString(tolerance));
    }
}
