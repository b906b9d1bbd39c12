package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Compares figures drawn by the manifest's commands with exact values. */
class FiguresTest extends InOneWorkplace {
    private static final int ANGLES = 501;

    @Test
    void fiveChecksOfTheThesissClaimsAgree() throws Exception {
        String verdicts = workplace
                .succeedHere("figures --output agree --size 48 --only 2.8,3.1,4.5,5.4,5.10")
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
        Path patches = Files.createDirectory(workplace.resolve("waves"));
        Images.gray(patches.resolve("wave.png"), 100, 100, (column, row) ->
                (int) Math.round(127.5 * (1 + Math.sin(2 * Math.PI * column / 100))));
        Files.writeString(
                patches.resolve("blaze.json"),
                "{\"heights\": \"wave.png\", \"width\": \"2.5 um\", \"maxHeight\": \"200 nm\"}");

        String verdicts = workplace
                .succeedHere("figures --output differ --patches waves --size 48 --only 5.4")
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
        workplace.succeedHere(
                "evaluate --patch lamellar --method pq --theta-i 0 --azimuth 0 --wavelengths 500:500:1"
                        + " --angles -25:25:0.1 --replicas %s --output q%s",
                replicas, replicas);
        return CsvFile.read(workplace.resolve("q" + replicas + ".csv"));
    }

    /** Figure 5.5: far orders of blaze are 1 nm wide. */
    @Test
    void stepsOfTenNanometersMissOrdersOfBlazeAndOfOneDoNot() throws Exception {
        // 0.045 measured.
        assertThat(error("10nm")).isGreaterThan(0.02);
        assertThat(error("1nm")).isLessThan(1e-3);
    }

    /** Returns the 95th percentile of the relative errors of Y in bright rows. */
    private static double error(String step) throws Exception {
        CsvFile exact = SharedData.reference("xyz", "blaze");
        return workplace
                .reflectance(SharedData.patch("blaze"), exact, "--wavelength-step " + step)
                .errors(exact, name -> name, "Y")
                .percentile95();
    }
}
