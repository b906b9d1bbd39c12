package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecisionTest {
    @Test
    void theGuideHasTheTable() throws IOException {
        List<String> guide = Files.readAllLines(Path.of("..", "docs", "evaluation.md"));
        List<String> rows = Arrays.stream(Decision.values()).map(Decision::row).toList();
        assertThat(guide).containsSequence(rows);
    }

    /** On both sides of the limits that the rows state; a sure grating but for what is given. */
    @ParameterizedTest
    @CsvSource({
        "0.079, 10, 10, 0.5, 50, 50, 50, 0.0, FAINT",
        "0.081, 10, 10, 0.5, 50, 50, 50, 0.0, SURE",
        "0.9, 2.9, 10, 0.9, 50, 50, 50, 0.0, TOO_FEW",
        "0.9, 3.9, 10, 0.9, 50, 50, 50, 0.0, FEW",
        "0.9, 10, 3.9, 0.5, 50, 50, 50, 0.0, UNDERSAMPLED",
        "0.9, 10, 10, 0.5, 50, 50, 50, 0.11, UNEVEN",
        "0.9, 10, 10, 0.05, 50, 50, 50, 0.0, NOISE",
        "0.9, 10, 10, 0.2, 50, 4.1, 41, 0.0, LIKELY",
        "0.9, 10, 10, 0.19, 50, 4.1, 41, 0.0, POSSIBLE",
        "0.9, 8, 10, 0.55, 959, 11.6, 2304, 0.005, SURE",
        "0.9, 8, 10, 0.55, 959, 11.6, 2304, 0.01, POSSIBLE",
        "0.9, 10, 10, 0.14, 50, 4.1, 41, 0.0, NOISE",
        "0.9, 10, 10, 0.5, 50, 50, 39, 0.0, POSSIBLE",
        "0.9, 10, 10, 0.7, 50, 50, 39, 0.0, SURE",
        "0.9, 5.6, 10, 0.375, 65, 21.6, 82, 0.005, SURE",
        "0.9, 3.4, 38, 0.85, 50, 34, 50, 0.067, FEW",
        "0.9, 3.6, 38, 0.38, 50, 34, 50, 0.3, LIKELY",
        "0.9, 5.6, 10, 0.375, 65, 21.6, 82, 0.03, LIKELY",
        "0.9, 5.6, 10, 0.375, 55, 14, 82, 0.1, POSSIBLE",
        "0.9, 10, 2.9, 0.5, 50, 50, 50, 0.0, UNRESOLVED",
        "0.9, 10, 2.9, 0.2, 50, 4.1, 41, 0.0, UNRESOLVED",
        "0.9, 10, 10, 0.2, 50, 4.1, 41, 0.051, POSSIBLE",
        "0.9, 10, 10, 0.2, 61, 4.1, 41, 0.0, POSSIBLE"
    })
    void rowsHoldFromTheirLimitsOn(
            double share,
            double periods,
            double samples,
            double lines,
            double contrast,
            double prominence,
            double significance,
            double width,
            Decision row) {
        Evidence wave = new Evidence(
                false,
                periods,
                samples,
                share,
                lines,
                contrast,
                1,
                prominence,
                significance,
                0,
                Double.POSITIVE_INFINITY,
                width);
        assertThat(Decision.of(wave)).isEqualTo(row);
    }
}
