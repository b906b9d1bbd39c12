package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.acceptance.CsvFile;
import sunbeam.acceptance.InOneWorkplace;
import sunbeam.acceptance.SharedData;
import sunbeam.precompute.errors.ErrorStatistics;

/**
 * Tolerance of method {@code full} on random directions of measured patches, compared with an independent program: a median relative error
 * of at most the tolerance and a 95th percentile of at most three times it.
 */
class PromiseTest extends InOneWorkplace {
    @ParameterizedTest
    @CsvSource({"blaze, 1e-4", "elaphe, 1e-2", "xenopeltis, 1e-3"})
    void powerKeepsTheTolerance(String patch, double tolerance) throws Exception {
        assertErrorsWithin(tolerance, "power", patch, "power");
    }

    /** Uses the default tolerance, since the independent colors of sharp orders have errors of 1e-4. */
    @ParameterizedTest
    @ValueSource(strings = {"blaze", "elaphe"})
    void colorKeepsTheTolerance(String patch) throws Exception {
        assertErrorsWithin(1e-3, "xyz", patch, "X", "Y", "Z");
    }

    private static void assertErrorsWithin(double tolerance, String kind, String patch, String... columns)
            throws Exception {
        CsvFile exact = SharedData.reference(kind, patch);

        ErrorStatistics errors = workplace
                .reflectance(SharedData.patch(patch), exact, "--average coherent --tolerance " + tolerance)
                .errors(exact, name -> name, columns);

        assertThat(errors.count()).isGreaterThan(5);
        assertThat(errors.keep(tolerance)).as("%s", errors).isTrue();
    }
}
