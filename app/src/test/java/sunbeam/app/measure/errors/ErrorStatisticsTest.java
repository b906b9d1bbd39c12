package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.app.measure.errors.Certificate.Limits;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

final class ErrorStatisticsTest {
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
    }

    @Test
    void aPictureFullOfNanMissesEveryTolerance() {
        ErrorStatistics statistics = ErrorStatistics.of(Double.NaN, 0, Double.NaN);
        assertThat(statistics.maximum()).isInfinite();
        assertThat(Limits.of(1).hold(statistics)).isFalse();
    }

    @Test
    void nothingComparedMissesNothing() {
        ErrorStatistics statistics = ErrorStatistics.of();
        assertThat(statistics.median()).isNaN();
        assertThat(Limits.of(1e-3).hold(statistics)).isTrue();
    }

    @Test
    void theMedianMayReachTheToleranceAndThePercentileThreeTimesIt() {
        Limits limits = Limits.of(1e-3);
        assertThat(limits.hold(new ErrorStatistics(9, 1e-3, 3e-3, 1, 1, 0))).isTrue();
        assertThat(limits.hold(new ErrorStatistics(9, 1.01e-3, 2e-3, 1, 1, 0))).isFalse();
        assertThat(limits.hold(new ErrorStatistics(9, 0.5e-3, 3.1e-3, 1, 1, 0))).isFalse();
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

    @Test
    void anExportThatMissesAtThe95thPercentileAloneMisses() {
        double[] errors = new double[100];
        Arrays.fill(errors, 0, 90, 0.01);
        Arrays.fill(errors, 90, 100, 0.15);
        assertThat(Certificate.Limits.ofExport(0.02).hold(ErrorStatistics.of(errors)))
                .isTrue();
        Arrays.fill(errors, 90, 100, 0.21);
        assertThat(Certificate.Limits.ofExport(0.02).hold(ErrorStatistics.of(errors)))
                .isFalse();
        assertThat(Certificate.Limits.ofExport(0.02).hold(ErrorStatistics.of())).isTrue();
    }
}
