package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.Srgb;

class SrgbStepsTest {
    private static final int LOOKS = 1_000_003;

    @Test
    void channelsAreThoseOfTheCurve() {
        for (int i = -1000; i <= LOOKS + 1000; i++) {
            double linear = (double) i / LOOKS;
            assertThat(SrgbSteps.channel(linear) & 0xff).as("%s", linear).isEqualTo(Srgb.channel(linear));
        }
    }

    @Test
    void eachChannelComesBack() {
        for (int channel = 0; channel < 256; channel++) {
            assertThat(SrgbSteps.channel(Srgb.linear(channel)) & 0xff).isEqualTo(channel);
        }
    }
}
