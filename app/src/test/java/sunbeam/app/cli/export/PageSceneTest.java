package sunbeam.app.cli.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Base64;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.texture.BodyTexture;

/** Textures in the elements of a page. */
class PageSceneTest {
    private static final int SIDE = 400;

    @Test
    void aLargeTextureKeepsWhereItsSkinIsBare() throws IOException {
        // Noise, of which a PNG is large; without alpha at one texel, as in an eye.
        byte[] rgba = new byte[4 * SIDE * SIDE];
        new Random(1).nextBytes(rgba);
        for (int i = 3; i < rgba.length; i += 4) {
            rgba[i] = (byte) (i / 4 == 5 * SIDE + 7 ? 0 : 255);
        }

        Matcher element = Pattern.compile("data-mask=\"data:image/png;base64,([^\"]*)\" id=\"skin\">data:image/jpeg;")
                .matcher(PageScene.element("skin", new BodyTexture(SIDE, SIDE, rgba)));

        assertThat(element.find()).isTrue();
        BufferedImage mask =
                ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(element.group(1))));
        assertThat(mask.getRaster().getSample(7, 5, 0)).isZero();
        assertThat(mask.getRaster().getSample(8, 5, 0)).isEqualTo(255);
    }
}
