package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.SettingException;

class PlanChecksTest {
    private static void requireSamples(double pitch) {
        HeightMap map = new HeightMap(16, 16, pitch, pitch, new double[256]);
        PlanChecks.requireSamples(CoherenceWindow.ofCoherenceLength(5e-6), map);
    }

    @Test
    void windowsOfFewSamplesAreRefusedWithTheSmallestLength() {
        assertThatCode(() -> requireSamples(1.2e-6)).doesNotThrowAnyException();
        assertThatThrownBy(() -> requireSamples(2e-6))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("give 8 um or more");
    }

    @Test
    void samplesThatShowNoStructureAreNotGivenALargerWindow() {
        assertThatThrownBy(() -> requireSamples(78e-6))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("check the scan's size and its unit");
    }
}
