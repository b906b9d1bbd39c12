package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;

/** On a table whose exact powers are 1, 1/2, 1/3 and so on. */
final class TableCertifierTest {
    private static final int ROWS = 200;

    private static double[] exact(int row) {
        return new double[] {1.0 / (row + 1)};
    }

    private static Certificate certify(double factor, int count) {
        return new TableCertifier(row -> new double[] {factor * exact(row)[0]}, TableCertifierTest::exact, "power")
                .certify(ROWS, count, 1e-3);
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
        assertThat(certificate.relativeL2()).isCloseTo(0.02, within(1e-12));
    }

    @Test
    void rowsAreDrawnOnceAndNoMoreThanThereAre() {
        Set<Integer> seen = ConcurrentHashMap.newKeySet();
        Certificate certificate = new TableCertifier(
                        TableCertifierTest::exact,
                        row -> {
                            assertThat(seen.add(row)).as("row %d", row).isTrue();
                            return exact(row);
                        },
                        "power")
                .certify(ROWS, 10_000, 1e-3);
        assertThat(certificate.places()).isEqualTo("all 200 rows");
        assertThat(seen).hasSize(ROWS);
    }

    @Test
    void darkRowsAreNotComparedUnlessTheTableHasLightThere() {
        Certificate dark = new TableCertifier(row -> new double[] {1e-12}, row -> new double[] {2e-12}, "power")
                .certify(ROWS, ROWS, 1e-3);
        assertThat(dark.relative().count()).isZero();
        assertThat(dark.missed()).isFalse();
        Certificate lit = new TableCertifier(row -> new double[] {1e-3}, row -> new double[] {2e-12}, "power")
                .certify(ROWS, ROWS, 1e-3);
        assertThat(lit.missed()).isTrue();
    }

    @Test
    void aTableFullOfNanIsWrong() {
        Certificate certificate = new TableCertifier(
                        row -> new double[] {Double.NaN}, TableCertifierTest::exact, "power")
                .certify(ROWS, 20, 1);
        assertThat(certificate.missed()).isTrue();
    }
}
