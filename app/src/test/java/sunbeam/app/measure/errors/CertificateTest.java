package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.measure.errors.Certificate.Limits;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

/** Statistics of errors and their limits; certificates of a table whose exact powers are 1, 1/2, 1/3 and so on. */
final class CertificateTest {
    private static final int ROWS = 200;

    private static double exact(int row) {
        return 1.0 / (row + 1);
    }

    private static Certificate certify(IntToDoubleFunction computed, IntToDoubleFunction exact, int count) {
        return Certificate.ofRows(
                new Environment(Map.of(), Path.of("")).progress(),
                ROWS,
                count,
                row -> new Comparison(
                        new double[] {computed.applyAsDouble(row)}, new double[] {exact.applyAsDouble(row)}, 1),
                "power",
                1e-3);
    }

    @Test
    void theExactTablePassesAndSaysWhatWasCompared() {
        Certificate certificate = certify(CertificateTest::exact, CertificateTest::exact, 50);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.relative().maximum()).isZero();
        assertThat(certificate.summary())
                .startsWith("50 random rows, 50 of them")
                .contains("relative error of power")
                .doesNotContain("CIEDE2000");
    }

    @Test
    void everyRowThatIsOffByTwoPercentCountsTheSameHoweverDark() {
        Certificate certificate = certify(row -> 1.02 * exact(row), CertificateTest::exact, 50);
        assertThat(certificate.missed()).isTrue();
        // Double precision's rounding.
        assertThat(certificate.relative().median()).isCloseTo(0.02, within(1e-12));
        assertThat(certificate.relative().maximum()).isCloseTo(0.02, within(1e-12));
    }

    @Test
    void rowsAreDrawnOnceAndNoMoreThanThereAre() {
        Set<Integer> seen = ConcurrentHashMap.newKeySet();
        Certificate certificate = certify(
                CertificateTest::exact,
                row -> {
                    assertThat(seen.add(row)).as("row %d", row).isTrue();
                    return exact(row);
                },
                10_000);
        assertThat(certificate.places()).isEqualTo("all 200 rows");
        assertThat(seen).hasSize(ROWS);
    }

    @Test
    void darkRowsAreNotComparedUnlessTheTableHasLightThere() {
        Certificate dark = certify(row -> 1e-12, row -> 2e-12, ROWS);
        assertThat(dark.relative().count()).isZero();
        assertThat(dark.missed()).isFalse();
        assertThat(certify(row -> 1e-3, row -> 2e-12, ROWS).missed()).isTrue();
        assertThat(certify(row -> Double.NaN, CertificateTest::exact, 20).missed())
                .isTrue();
    }

    @Test
    void quantilesLieBetweenTheirNeighborsInAnyOrder() {
        double[] shuffled =
                IntStream.range(0, 101).mapToDouble(i -> (i * 37) % 101).toArray();
        ErrorStatistics statistics = ErrorStatistics.of(shuffled);
        assertThat(statistics.count()).isEqualTo(101);
        assertThat(statistics.median()).isEqualTo(50);
        assertThat(statistics.percentile95()).isCloseTo(95, within(1e-12));
        assertThat(statistics.maximum()).isEqualTo(100);
        assertThat(ErrorStatistics.of(1, 2).median()).isEqualTo(1.5);
        assertThat(ErrorStatistics.of().median()).isNaN();
        assertThat(ErrorStatistics.of(Double.NaN, 0, 0).maximum()).isInfinite();
    }

    @ParameterizedTest
    @CsvSource({
        "1e-3, 3e-3, true",
        "1.01e-3, 2e-3, false",
        "0.5e-3, 3.1e-3, false",
        "Infinity, Infinity, false",
    })
    void theMedianMayReachTheToleranceAndThePercentileThreeTimesIt(double median, double percentile95, boolean holds) {
        assertThat(Limits.of(1e-3).hold(new ErrorStatistics(9, median, percentile95, 1, 1, 0)))
                .isEqualTo(holds);
        assertThat(Limits.of(1e-3).hold(ErrorStatistics.of())).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"0.15, true", "0.21, false"})
    void anExportThatMissesAtThe95thPercentileAloneMisses(double largest, boolean holds) {
        double[] errors = new double[100];
        Arrays.fill(errors, 0, 90, 0.01);
        Arrays.fill(errors, 90, 100, largest);
        assertThat(Limits.ofExport(0.02).hold(ErrorStatistics.of(errors))).isEqualTo(holds);
    }

    @Test
    void aColorsErrorIsRelativeToItsStrongestChannel() {
        double error = new Comparison(new double[] {0.5, 0.2, 0.02}, new double[] {0.5, 0.21, 0.01}, 1).relative();
        assertThat(error).isCloseTo(0.02, within(1e-12));
    }

    @Test
    void fewErrorsAreReportedAsUncertain() {
        assertThat(ErrorStatistics.of(new double[10]).doubt()).as("0.95^10").contains("with a chance of 60 %");
        assertThat(ErrorStatistics.of(new double[59]).doubt())
                .as("0.95^59 is 4.8 %")
                .isEmpty();
        assertThat(ErrorStatistics.of().doubt()).isEmpty();
    }
}
