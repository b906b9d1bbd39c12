package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.files.cache.BlobCache;

class ScaleReliefTest {
    private static double slope(BodyTexture relief, int texel, int channel) {
        return ScaleRelief.STEEPEST * ((relief.rgba()[4 * texel + channel] & 0xff) - 128) / 127;
    }

    @ParameterizedTest
    @EnumSource(names = {"SMOOTH", "KEELED"})
    void scalesRiseTowardsTheTailAndAreDomesAcross(Scales scales) {
        BodyTexture relief = ScaleRelief.of(scales, BlobCache.NONE);
        int texels = relief.width() * relief.height();
        double along = 0;
        double around = 0;
        double steep = 0;
        for (int i = 0; i < texels; i++) {
            along += slope(relief, i, 0) / texels;
            around += slope(relief, i, 1) / texels;
            steep += Math.hypot(slope(relief, i, 0), slope(relief, i, 1)) / texels;
        }
        // Each covers the next one's front: on the way to the tail skin rises slowly and falls in steps, which a normal
        // map leaves out.
        assertThat(along).isBetween(0.01, 0.12);
        // Left and right are alike but for chance.
        assertThat(around).isCloseTo(0, within(3e-3));
        // Soft plates: some degrees.
        assertThat(steep).isBetween(0.04, 0.2);
    }

    @Test
    void noScalesAreEvenSkinOfItsOwnColor() {
        BodyTexture relief = ScaleRelief.of(Scales.NONE, BlobCache.NONE);
        assertThat(slope(relief, 0, 0)).isZero();
        assertThat(slope(relief, 0, 1)).isZero();
        assertThat((relief.rgba()[3] & 0xff) / 255.0 * ScaleRelief.LIGHTEST).isCloseTo(1, within(0.003));
    }
}
