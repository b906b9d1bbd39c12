package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares {@code reflectance --method reference} with an independent program's direct sums, on measured and synthetic patches. */
class SharedReferenceTest extends InOneWorkplace {
    @ParameterizedTest
    @ValueSource(strings = {"blaze", "elaphe", "xenopeltis"})
    void everyPowerIsTheSame(String patch) throws Exception {
        CsvFile exact = SharedData.reference("power", patch);

        CsvFile ours = workplace.reflectance(SharedData.patch(patch), exact, "--method reference --both-averages");

        for (int row = 0; row < exact.size(); row++) {
            for (String column : List.of("power", "power_ensemble", "rho", "brdf")) {
                double value = exact.at(row, column);
                // Files have 12 digits; the programs' rounding, 2e-15 / sqrt(power), matters below a power of 1e-12.
                assertThat(ours.at(row, column))
                        .as("row %d, %s", row, column)
                        .isCloseTo(value, within(Math.max(1e-9 * value, 1e-20)));
            }
        }
    }

    /** Compares with Gauss-Legendre quadratures of the linear 1 nm tables, relative to the largest of X, Y, Z. */
    @ParameterizedTest
    @ValueSource(strings = {"xyz_nonsq", "xyz_8x1um"})
    void colorsOfSharpOrdersAreExact(String name) throws Exception {
        CsvFile exact = CsvFile.read(SharedData.hardCase(name + "/in.csv")).head(20);
        Path patch = SharedData.hardCase(name + "/p.json");

        CsvFile ours = workplace.reflectance(patch, exact, "--method reference");

        for (int row = 0; row < exact.size(); row++) {
            double largest =
                    Math.max(exact.at(row, "exact_X"), Math.max(exact.at(row, "exact_Y"), exact.at(row, "exact_Z")));
            for (String column : List.of("X", "Y", "Z")) {
                // Refined until 1e-9 (WindowLight); measured against these files 1e-12 in the median, 4e-8 at most.
                assertThat(ours.at(row, column))
                        .as("row %d, %s", row, column)
                        .isCloseTo(exact.at(row, "exact_" + column), within(Math.max(1e-7 * largest, 1e-20)));
            }
        }
    }
}
