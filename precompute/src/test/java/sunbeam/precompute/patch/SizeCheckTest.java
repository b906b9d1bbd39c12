package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class SizeCheckTest {
    private static Optional<String> told(double width, double height) {
        return SizeCheck.size(new HeightMap(4, 2, width / 4, height / 2, new double[8]));
    }

    @Test
    void aWrongUnitIsGuessedFromTheSize() {
        assertThat(told(20e-3, 10e-3).orElseThrow()).contains("20 mm wide", "unit", "below it would be 20 um");
        assertThat(told(10e-9, 20e-9).orElseThrow()).contains("20 nm wide", "unit", "above it would be 20 um");
        // No neighbouring unit makes a usual scan of it.
        assertThat(told(0.9, 0.9).orElseThrow()).contains("900 mm wide", "unit").doesNotContain("would be");
    }

    @Test
    void scansOfMicroscopesAreLeftAlone() {
        assertThat(told(1e-6, 0.3e-6)).isEmpty();
        assertThat(told(90e-6, 90e-6)).isEmpty();
        // An interference microscope's, or a small pattern's unit cell.
        assertThat(told(0.8e-3, 0.6e-3)).isEmpty();
        assertThat(told(380e-9, 380e-9)).isEmpty();
    }
}
