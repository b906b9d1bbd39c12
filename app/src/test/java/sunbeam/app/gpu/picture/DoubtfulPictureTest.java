package sunbeam.app.gpu.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.terminal.ExitCode;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;

class DoubtfulPictureTest {
    private static final BufferedImage BLACK = new BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB);
    private static final Patch MIRROR = patch(0);
    // Half a nanometer: 7e-5 of the light at most.
    private static final Patch NEARLY_FLAT = patch(0.5e-9);
    private static final Patch STEP = patch(1e-7);

    private static Patch patch(double step) {
        return new Patch("step", new HeightMap(2, 1, 1e-7, 1e-7, new double[] {0, step}), "made up", List.of());
    }

    private static BufferedImage lit() {
        BufferedImage image = new BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB);
        image.setRGB(3, 5, 0x000001);
        return image;
    }

    private static ExitCode judge(Patch patch, BufferedImage image, StringWriter said) {
        return judge(patch, image, false, said);
    }

    private static ExitCode judge(Patch patch, BufferedImage image, boolean automatic, StringWriter said) {
        return DoubtfulPicture.judge(
                List.of(STEP, patch), DoubtfulPicture.isBlack(image), "the map", automatic, new PrintWriter(said));
    }

    @Test
    void theMapOfAMirrorIsDoubtful() {
        assertThat(judge(MIRROR, lit(), new StringWriter()).code()).isEqualTo(3);
        assertThat(judge(NEARLY_FLAT, lit(), new StringWriter()).code()).isEqualTo(3);
        assertThat(DoubtfulPicture.ofPatches(List.of(STEP, MIRROR)).code()).isEqualTo(3);
        assertThat(DoubtfulPicture.ofPatches(List.of(STEP))).isEqualTo(ExitCode.OK);
    }

    @Test
    void aBlackMapIsDoubtfulAndSaysWhatHelps() {
        StringWriter said = new StringWriter();

        assertThat(judge(STEP, BLACK, said).code()).isEqualTo(3);
        assertThat(said.toString()).contains("warning: the map is black all over; let the exposure be automatic");

        StringWriter found = new StringWriter();
        assertThat(judge(STEP, BLACK, true, found).code()).isEqualTo(3);
        assertThat(found.toString())
                .as("nobody can let it be what it is")
                .contains("the map is black all over", "move the light")
                .doesNotContain("be automatic");
    }
}
