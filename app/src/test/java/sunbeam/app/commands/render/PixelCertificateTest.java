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

        assertThat(PixelCertificate.remedy(full)).contains("--supersample").contains("--method table");
        assertThat(PixelCertificate.remedy(table)).contains("--supersample").doesNotContain("--method");
    }

    @Test
    void aTextureMayBeTheCause() {
        assertThat(PixelCertificate.remedy(table)).contains("the texture elaphe");
        assertThat(PixelCertificate.remedy(table.withTexture(BodyTextures.NONE)))
                .doesNotContain("texture");
    }
}
