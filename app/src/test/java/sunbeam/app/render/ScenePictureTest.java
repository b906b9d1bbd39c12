package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ScenePictureTest {
    @Test
    void theGroundDoesNotCountAsLightOfTheMesh() {
        ScenePicture samples = ScenePicture.empty(2, 2);
        for (int sample = 0; sample < 4; sample++) {
            boolean isMesh = sample == 0;
            for (int c = 0; c < 3; c++) {
                samples.rgba()[4 * sample + c] = isMesh ? 0.25f : 2;
            }
            samples.rgba()[4 * sample + 3] = isMesh ? 1 : 0.75f;
        }

        ScenePicture pixel = samples.reduced(2);

        assertThat(pixel.linear().luminance(0)).isEqualTo(0.25f);
        assertThat(pixel.rgba()[3]).as("coverage").isEqualTo(0.25f);
    }
}
