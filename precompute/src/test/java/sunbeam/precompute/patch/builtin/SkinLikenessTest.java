package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.HeightMap;

/** The generated skins compared with the scans they imitate, if present. */
class SkinLikenessTest {
    private static final Path SCANS = Path.of("..", "..", "shared", "patches");
    private static final double WIDTH = 65e-6;
    /** Where sectors begin, in degrees from the x axis. */
    private static final double[] SECTORS = {0, 5, 15, 30, 45, 60, 75, 85};

    /** Where rings begin, in periods across the patch. */
    private static final double[] RINGS = {1, 4, 40, 60, 80, 100, 140, 200};

    @ParameterizedTest
    @CsvSource({"elaphe, 375", "xenopeltis, 818.69"})
    void spectraHoldTheSamePowerInEachDirectionAndRing(String name, double fullScaleNm) throws IOException {
        Path file = SCANS.resolve(name + ".png");
        assumeTrue(Files.isReadable(file), "no scan at " + file);
        Spectrum scan = new Spectrum(read(file, fullScaleNm * 1e-9));
        Spectrum skin = new Spectrum(BuiltInPatches.generate(name + "-like"));
        double[] ratios = ratios(bySector(skin), bySector(scan));
        // Orders agree to 25 %; between them the scans have dust, scratches and broken rows.
        for (int i = 0; i < ratios.length; i++) {
            assertThat(ratios[i]).as("sector from %s degrees", SECTORS[i]).isBetween(0.6, 1.3);
        }
        ratios = ratios(byRing(skin), byRing(scan));
        for (int i = 0; i < ratios.length; i++) {
            assertThat(ratios[i]).as("ring from %s periods", RINGS[i]).isBetween(0.6, 1.3);
        }
    }

    /** Roughness beyond waviness that visible light resolves, up to 2 / 380 nm, without the cross of the scans' edges. */
    private static double[] bySector(Spectrum spectrum) {
        double[] sums = new double[SECTORS.length];
        spectrum.forEach((p, q, meanSquare) -> {
            double radius = Math.hypot(p, q);
            if (radius >= 12 && radius < 342 && Math.abs(p) > 1 && Math.abs(q) > 1) {
                double angle = Math.toDegrees(Math.atan2(Math.abs(q), Math.abs(p)));
                sums[interval(SECTORS, angle)] += meanSquare;
            }
        });
        return sums;
    }

    private static double[] byRing(Spectrum spectrum) {
        double[] sums = new double[RINGS.length];
        spectrum.forEach((p, q, meanSquare) -> {
            double radius = Math.hypot(p, q);
            if (radius >= 1 && radius < 342) {
                sums[interval(RINGS, radius)] += meanSquare;
            }
        });
        return sums;
    }

    private static int interval(double[] starts, double value) {
        int last = starts.length - 1;
        while (starts[last] > value) {
            last--;
        }
        return last;
    }

    /** Of amplitudes. */
    private static double[] ratios(double[] skin, double[] scan) {
        return IntStream.range(0, skin.length)
                .mapToDouble(i -> Math.sqrt(skin[i] / scan[i]))
                .toArray();
    }

    private static HeightMap read(Path file, double fullScale) throws IOException {
        BufferedImage image = ImageIO.read(file.toFile());
        int columns = image.getWidth();
        int rows = image.getHeight();
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = image.getRaster().getSample(i % columns, i / columns, 0) / 255.0 * fullScale;
        }
        return new HeightMap(columns, rows, WIDTH / columns, WIDTH / rows, heights);
    }
}
