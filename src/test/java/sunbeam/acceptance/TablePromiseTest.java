package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Tolerance of method {@code table} on a surface that was not used to find its steps: a sawtooth at an angle to the samples has sharp
 * orders all over (u, v), with dark lines between their tails.
 */
@Tag("thorough")
final class TablePromiseTest extends InWorkplace {
    private static final int SAMPLES = 256;

    private static void write(Path file) throws IOException {
        BufferedImage image = new BufferedImage(SAMPLES, SAMPLES, BufferedImage.TYPE_USHORT_GRAY);
        for (int y = 0; y < SAMPLES; y++) {
            for (int x = 0; x < SAMPLES; x++) {
                image.getRaster().setSample(x, y, 0, (13 * x + 7 * y) % SAMPLES * 257);
            }
        }
        ImageIO.write(image, "png", file.toFile());
    }

    private SunbeamResult map(String more) throws IOException {
        return workplace.here("brdf-map --patch angled.png --width 12um --max-height 120nm --method table"
                + " --average coherent --tolerance 1e-2 --size 128 " + more);
    }

    @Test
    void aTableKeepsItsToleranceWhereItsLawsDoNot() throws Exception {
        write(workplace.resolve("angled.png"));

        SunbeamResult result = map("--certify 80 --output map.png");

        // With the default steps the 95th percentile would be 0.15.
        assertThat(result.exitCode()).as(result::toString).isZero();
        assertThat(result.stderr()).contains("baked again in steps of");

        // The second run reads the validated table from the cache.
        SunbeamResult again = map("--output again.png");
        assertThat(again.exitCode()).as(again::toString).isZero();
        assertThat(again.stderr()).doesNotContain("baked again");
    }
}
