package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import sunbeam.app.measure.accuracy.CaseRunner.Outcome;
import sunbeam.app.measure.accuracy.CaseRunner.Verdict;
import sunbeam.app.measure.errors.ErrorStatistics;

final class OutcomeTest {
    @Test
    void programsReadTheErrorsAndTheVerdict() {
        Map<String, Object> fields = new Outcome(
                        "step", "power", 1e-3, ErrorStatistics.of(1e-5, 3e-5, 2e-3), Verdict.MISSED_AS_SAID, "plan")
                .fields();

        assertThat(fields)
                .containsEntry("case", "step")
                .containsEntry("verdict", "missed as said")
                .containsEntry("rows", 3)
                .containsEntry("median", 3e-5)
                .containsEntry("maximum", 2e-3);
    }

    @Test
    void aRefusalHasNoErrors() {
        Map<String, Object> fields =
                new Outcome("step", "-", 1e-3, ErrorStatistics.of(), Verdict.REFUSED, "too deep").fields();

        assertThat(fields).containsEntry("verdict", "refused").containsEntry("plan", "too deep");
        assertThat(fields).doesNotContainKeys("median", "rows");
    }
}
