package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tolerance of method {@code table} on a surface that was not used to find its steps: a sawtooth at an angle to the samples has sharp
 * orders all over (u, v), with dark lines between their tails.
 */
@Tag("thorough")
final class TablePromiseTest {
    private static final int SAMPLES = 256;

    @TempDir
    private Path root;

    private static void write(Path file) throws IOException {
        BufferedImage image = new BufferedImage(SAMPLES, SAMPLES, BufferedImage.TYPE_USHORT_GRAY);
        for (int y = 0; y < SAMPLES; y++) {
            for (int x = 0; x < SAMPLES; x++) {
                image.getRaster().setSample(x, y, 0, (13 * x + 7 * y) % SAMPLES * 257);
            }
        }
        ImageIO.write(image, "png", file.toFile());
    }

    private static SunbeamResult map(Workplace workplace, String... more) throws IOException {
        List<String> words = new ArrayList<>(List.of("brdf-map", "--patch", "angled.png", "--width", "12um"));
        words.addAll(List.of("--max-height", "120nm", "--method", "table", "--average", "coherent"));
        words.addAll(List.of("--tolerance", "1e-2", "--size", "128"));
        words.addAll(List.of(more));
        return workplace.here(words.toArray(String[]::new));
    }

    @Test
    void aTableKeepsItsToleranceWhereItsLawsDoNot() throws Exception {
        Workplace workplace = Workplace.in(root);
        write(workplace.resolve("angled.png"));

        SunbeamResult result = map(workplace, "--certify", "80", "--output", "map.png");

        // With the default steps the 95th percentile would be 0.15.
        assertThat(result.exitCode()).as(result::toString).isZero();
        assertThat(result.stderr()).contains("baked again in steps of");

        // The second run reads the validated table from the cache.
        SunbeamResult again = map(workplace, "--output", "again.png");
        assertThat(again.exitCode()).as(again::toString).isZero();
        assertThat(again.stderr()).doesNotContain("baked again");
    }
}
