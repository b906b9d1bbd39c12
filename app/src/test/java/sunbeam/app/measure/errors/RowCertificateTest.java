package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.errors.Comparison;

/** On a table whose exact powers are 1, 1/2, 1/3 and so on. */
final class RowCertificateTest {
    private static final int ROWS = 200;

    private static double[] exact(int row) {
        return new double[] {1.0 / (row + 1)};
    }

    private static Certificate certify(IntFunction<double[]> computed, IntFunction<double[]> exact, int count) {
        return Certificate.ofRows(
                new Environment(Map.of(), Path.of("")).progress(),
                ROWS,
                count,
                row -> new Comparison(computed.apply(row), exact.apply(row), 1),
                "power",
                1e-3);
    }

    private static Certificate certify(double factor, int count) {
        return certify(row -> new double[] {factor * exact(row)[0]}, RowCertificateTest::exact, count);
    }

    @Test
    void theExactTablePassesAndSaysWhatWasCompared() {
        Certificate certificate = certify(1, 50);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.relative().count()).isEqualTo(50);
        assertThat(certificate.relative().maximum()).isZero();
        assertThat(certificate.summary())
                .startsWith("50 random rows")
                .contains("relative error of power")
                .doesNotContain("CIEDE2000");
    }

    @Test
    void everyRowThatIsOffByTwoPercentCountsTheSameHoweverDark() {
        Certificate certificate = certify(1.02, 50);
        assertThat(certificate.missed()).isTrue();
        // Double precision's rounding.
        assertThat(certificate.relative().median()).isCloseTo(0.02, within(1e-12));
        assertThat(certificate.relative().maximum()).isCloseTo(0.02, within(1e-12));
    }

    @Test
    void rowsAreDrawnOnceAndNoMoreThanThereAre() {
        Set<Integer> seen = ConcurrentHashMap.newKeySet();
        Certificate certificate = certify(
                RowCertificateTest::exact,
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
        Certificate dark = certify(row -> new double[] {1e-12}, row -> new double[] {2e-12}, ROWS);
        assertThat(dark.relative().count()).isZero();
        assertThat(dark.missed()).isFalse();
        Certificate lit = certify(row -> new double[] {1e-3}, row -> new double[] {2e-12}, ROWS);
        assertThat(lit.missed()).isTrue();
    }

    @Test
    void aTableFullOfNanIsWrong() {
        Certificate certificate = certify(row -> new double[] {Double.NaN}, RowCertificateTest::exact, 20);
        assertThat(certificate.missed()).isTrue();
    }
}
