package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compares figures drawn by the manifest's commands with exact values. */
class FiguresTest {
    private static final double LEAST_POWER = 1e-9;
    private static final int ANGLES = 501;

    @TempDir
    static Path root;

    private static Workplace workplace;

    @BeforeAll
    static void layOut() throws Exception {
        workplace = Workplace.in(root);
    }

    @Test
    void fiveChecksOfTheThesissClaimsAgree() throws Exception {
        String verdicts = workplace
                .succeedHere("figures", "--output", "agree", "--size", "48", "--only", "2.8,3.1,4.5,5.4,5.10")
                .stdout();

        assertThat(verdicts)
                .contains(
                        "2.8 agrees: number",
                        "3.1 agrees: number",
                        "4.5 agrees: width of the maximum",
                        "5.4 agrees: share of light on the left",
                        "5.10 agrees: chroma of the light");
    }

    /** A symmetric wave has no bright side, unlike a blaze. */
    @Test
    void aSurfaceThatIsNoBlazeFailsTheCheckOfBlaze() throws Exception {
        BufferedImage wave = new BufferedImage(100, 100, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 10_000; i++) {
            int height = (int) Math.round(127.5 * (1 + Math.sin(2 * Math.PI * (i % 100) / 100)));
            wave.getRaster().setSample(i % 100, i / 100, 0, height);
        }
        Path patches = Files.createDirectory(workplace.resolve("waves"));
        ImageIO.write(wave, "png", patches.resolve("wave.png").toFile());
        Files.writeString(
                patches.resolve("blaze.json"),
                "{\"heights\": \"wave.png\", \"width\": \"2.5 um\", \"maxHeight\": \"200 nm\"}");

        String verdicts = workplace
                .succeedHere(
                        "figures",
                        "--output",
                        "differ",
                        "--patches",
                        patches.toString(),
                        "--size",
                        "48",
                        "--only",
                        "5.4")
                .stdout();

        assertThat(verdicts).contains("5.4 differs: share of light on the left: blaze-full 0.5");
    }

    /** Figure 4.5: seven periods over one are the array factor (sin 7 pi t / 7 sin pi t)^2, t = d sin theta / lambda. */
    @Test
    void sevenPeriodsSharpenMaximaByTheArrayFactor() throws Exception {
        CsvFile one = response(1);
        CsvFile seven = response(7);

        double largest = IntStream.range(0, ANGLES)
                .mapToDouble(i -> one.at(0, angle(i)))
                .max()
                .orElseThrow();
        for (int i = 0; i < ANGLES; i++) {
            double turns = Math.PI * 2.5e-6 * Math.sin(Math.toRadians(-25 + 0.1 * i)) / 500e-9;
            double factor = Math.abs(Math.sin(turns)) < 1e-9 ? 1 : Math.sin(7 * turns) / (7 * Math.sin(turns));
            // Float32 leaves 1e-5 of the sines' arguments; at a flank of the factor that is 1e-4 of the brightest
            // angle.
            assertThat(seven.at(0, angle(i)))
                    .as("%s degrees", angle(i))
                    .isCloseTo(factor * factor * one.at(0, angle(i)), within(1e-4 * largest));
        }
    }

    private static String angle(int i) {
        return String.format(Locale.ROOT, "%.6f", -25 + 0.1 * i);
    }

    private static CsvFile response(int replicas) throws Exception {
        String options =
                "--patch lamellar --method pq --theta-i 0 --azimuth 0 --wavelengths 500:500:1 --angles -25:25:0.1";
        List<String> words = new ArrayList<>(List.of(options.split(" ", -1)));
        words.addAll(List.of("--replicas", Integer.toString(replicas), "--output", "q" + replicas));
        words.add(0, "evaluate");
        workplace.succeedHere(words.toArray(String[]::new));
        return CsvFile.read(workplace.resolve("q" + replicas + ".csv"));
    }

    /** Figure 5.12: what is left of exp(i k w h) after N Taylor terms. */
    @Test
    void elevenTaylorTermsAreTooFewForElapheAndFortyEnough() throws Exception {
        // The phase is up to 6.2 at 380 nm: x^11 / 11! is 13, x^40 / 40! 6e-16; float32 leaves 1e-5 of a sum of such
        // terms.
        assertThat(error(0.95, "power", "power", "elaphe", "--expansion", "taylor", "--terms", "11"))
                .isGreaterThan(5e-3);
        assertThat(error(0.95, "power", "power", "elaphe", "--expansion", "taylor", "--terms", "40"))
                .isLessThan(1e-3);
    }

    /** Figure 5.5: far orders of blaze are 1 nm wide. */
    @Test
    void stepsOfTenNanometersMissOrdersOfBlazeAndOfOneDoNot() throws Exception {
        // 0.045 measured.
        assertThat(error(0.95, "xyz", "Y", "blaze", "--wavelength-step", "10nm"))
                .isGreaterThan(0.02);
        assertThat(error(0.95, "xyz", "Y", "blaze", "--wavelength-step", "1nm")).isLessThan(1e-3);
    }

    /** Returns a quantile of the relative errors of bright rows. */
    private static double error(double quantile, String kind, String column, String patch, String... options)
            throws Exception {
        CsvFile exact = SharedData.reference(kind, patch);
        CsvFile ours = Reflectance.of(workplace, SharedData.patch(patch).toString(), exact, options);
        double[] errors = IntStream.range(0, exact.size())
                .filter(row -> exact.at(row, column) > LEAST_POWER)
                .mapToDouble(row -> Math.abs(ours.at(row, column) / exact.at(row, column) - 1))
                .sorted()
                .toArray();
        return errors[(int) (quantile * (errors.length - 1))];
    }
}
