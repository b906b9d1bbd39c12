package sunbeam.app.commands.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.texture.BodyTextures;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.setting.Choices;

class PixelCertificateTest {
    private final Scene table = Scenes.load("elaphe");

    /** Whoever has the method is not told to take it. */
    @Test
    void theMethodIsNoRemedyForItself() {
        Scene full = table.withMethod(table.method().with(Choices.none().with(Methods.METHOD, FullMethod.TYPE)));

        assertThat(PixelCertificate.remedy(full, 1)).contains("--supersample").contains("--method table");
        assertThat(PixelCertificate.remedy(table, 2)).contains("--supersample").doesNotContain("--method");
        assertThat(PixelCertificate.remedy(table, 8))
                .contains("--size")
                .contains("--tolerance")
                .doesNotContain("--supersample");
    }

    @Test
    void aTextureMayBeTheCause() {
        assertThat(PixelCertificate.remedy(table, 2)).contains("the texture elaphe");
        assertThat(PixelCertificate.remedy(table.withTexture(BodyTextures.NONE), 2))
                .doesNotContain("texture");
    }
}
