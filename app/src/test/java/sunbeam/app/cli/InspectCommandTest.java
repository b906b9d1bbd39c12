package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.ExitCode;

final class InspectCommandTest extends CommandLineFixture {
    @Test
    void aPatchIsTold() throws IOException {
        assertSuccess(sunbeam("inspect disc --output @sheet.png"));
        assertThat(out.toString())
                .startsWith("A grating of 1.6")
                .containsPattern(" across (0|180) degrees: first-order colors at 14 to 26 degrees")
                .contains("51.2 um x 51.2 um, 1024 x 1024 samples", "relief 110 nm", "steeper than 30 degrees")
                .containsPattern("period +1600.* nm, 95 % interval 1[56]")
                .endsWith(folder.resolve("sheet.png") + System.lineSeparator());
        assertThat(out.toString()).hasLineCount(6);
        BufferedImage sheet = ImageIO.read(folder.resolve("sheet.png").toFile());
        assertThat(sheet.getWidth()).isGreaterThan(1000);
        assertThat(sheet.getHeight()).isGreaterThan(1000);
    }

    @Test
    void lightThatTheModelAddsIsTold() {
        // Order 4 of 2.5 um lies flat at 620 nm under light from above.
        assertSuccess(sunbeam("inspect blaze --output @sheet.png"));
        assertThat(out.toString())
                .containsPattern(
                        "energy    from above, at 620 nm the model reflects 1.1\\d times the light of a mirror");
    }

    /** Elaphe's ridges are uneven; each part holds ten or more, and is judged by them: none has a white gloss. */
    @ParameterizedTest
    @ValueSource(strings = {"10um:40um,30um:60um", "5um:15um,5um:15um", "40um:60um,5um:25um"})
    void partsOfASkinWithUnevenRidgesShowTheirWave(String part) {
        Path skin = Path.of("..", "..", "shared", "patches", "elaphe.png").toAbsolutePath();
        assumeTrue(Files.exists(skin), () -> "the measured patches are not there: " + skin);
        assertSuccess(sunbeam(
                "inspect " + skin + " --width 65um --max-height 375nm --crop " + part + " --output @sheet.png"));
        // The whole has 1.06 um. A sure interval holds that; a part of 10 um may be too little, but its wave is named.
        assertThat(out.toString())
                .matches("(?s)(Probably a grating of about 1\\.|A grating of 1\\.\\d+ um \\(1\\.0[0-6]\\d* to 1\\.|"
                        + "Too little to judge: a wave of about 1\\.1 um may be there).*");
    }

    @Test
    void jsonDoesNotChangeThePicture() throws IOException {
        assertSuccess(sunbeam("inspect sinusoid --output @plain.png"));
        assertSuccess(sunbeam("inspect sinusoid --json --output @json.png"));
        assertThat(folder.resolve("json.png")).hasSameBinaryContentAs(folder.resolve("plain.png"));
    }

    @Test
    void whatContradictsItselfIsOneLine() {
        assertComplaint(ExitCode.USAGE, "inspect sinusoid --json --output -", "--json", "--output -");
        assertComplaint(ExitCode.USAGE, "inspect disc --patch blaze", "'disc'", "--patch", "one of them");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void flatAndThinPatchesHaveSheetsToo() throws IOException {
        int[][] sizes = {{300, 1}, {1, 300}, {40, 30}};
        for (int[] size : sizes) {
            scan("flat.txt", "", size[0], size[1], (column, row) -> 0);
            String width = " --columns " + size[0] + " --width " + size[0] * 50 + "nm";
            int code = sunbeam("inspect @flat.txt --height-unit nm --output @sheet.png --force" + width);
            // A mirror is most likely a mistake, so the exit code is 3.
            assertThat(code).as("%s x %s: %s", size[0], size[1], err).isEqualTo(3);
            assertThat(out.toString()).startsWith("A mirror: ").contains("relief 0 m");
        }
    }

    /** Filled rows are smoother than the surface: they would hide steep slopes. */
    @Test
    void statisticsAreThoseOfMeasuredRows() throws IOException {
        JsonNode whole = statistics(64);
        JsonNode half = statistics(32);
        for (String key : new String[] {"roughness_m", "rms_slope", "share_steeper_than_30_deg"}) {
            double expected = whole.get(key).doubleValue();
            assertThat(expected).as(key).isPositive();
            // The plane of half of the rows differs a little.
            assertThat(half.get(key).doubleValue()).as(key).isCloseTo(expected, withinPercentage(3));
        }
    }

    /** The right half is missing, and filled with the height of its border. */
    @Test
    void panelsShowMeasuredSamplesAlone() throws IOException {
        scan(
                "half.txt",
                "",
                64,
                64,
                (column, row) -> column < 32 ? 150 * Math.sin(2 * Math.PI * (column + 0.5) / 16) : Double.NaN);
        String options = " @half.txt --height-unit nm --width 5um --level none --force --output @half.png";
        sunbeam("inspect --json" + options);
        assertThat(new ObjectMapper()
                        .readTree(out.toString())
                        .get("roughness_m")
                        .doubleValue())
                .isCloseTo(150e-9 / Math.sqrt(2), withinPercentage(0.01));
        forgetOutput();
        sunbeam("inspect --panel histogram" + options);
        assertThat(out.toString()).contains("gaps      2048 of 4096 samples are missing");
        double[][] shares = rows("half.csv");
        double all = Arrays.stream(shares).mapToDouble(row -> row[1]).sum() * (shares[1][0] - shares[0][0]);
        assertThat(all).isCloseTo(1, withinPercentage(1e-6));
        // The wave has eight heights, each as often as the others.
        double most = Arrays.stream(shares).mapToDouble(row -> row[1]).max().orElseThrow();
        assertThat(most * (shares[1][0] - shares[0][0])).isLessThan(1.0 / 8 + 1e-9);
        sunbeam("inspect --panel profile" + options);
        double[][] line = rows("half.csv");
        assertThat(Arrays.stream(line).filter(row -> Double.isNaN(row[1])).count())
                .isBetween(line.length / 2 - 1L, line.length / 2 + 1L);
    }

    private JsonNode statistics(int measured) throws IOException {
        forgetOutput();
        scan(
                "part.txt",
                "",
                64,
                64,
                (column, row) -> row < measured ? 150 * Math.sin(2 * Math.PI * column / 16) : Double.NaN);
        sunbeam("inspect @part.txt --height-unit nm --width 5um --json --output @part.png --force");
        return new ObjectMapper().readTree(out.toString());
    }

    /** Writes a tilted wave as a scan of 10 x 5 um in text. */
    private void scan(double amplitudeNm, boolean spiked) throws IOException {
        scan("scan.txt", "", 128, 64, (column, row) -> {
            double wave = amplitudeNm * Math.sin(2 * Math.PI * column * 0.078125 / 0.9) * (1 + row / 640.0);
            boolean spike = spiked && ((row == 20 && column == 30) || (row == 50 && column == 99));
            return wave * (1 + 0.01 * column) + (spike ? 40 * amplitudeNm : 0);
        });
    }

    private void inspectScan(int code, String options) {
        forgetOutput();
        String width = options.contains("--width") ? "" : " --width 10um";
        assertThat(sunbeam("inspect @scan.txt --height-unit nm --force --output @sheet.png" + width + options))
                .as("%s", err)
                .isEqualTo(code);
    }

    @Test
    void aScanIsPreparedAsTheOptionsSay() throws IOException {
        scan(30, true);
        inspectScan(0, " --explain --despike");
        assertThat(out.toString())
                .contains(
                        "levelling plane",
                        "2 spike samples removed, the highest by 1.",
                        "edges blended over 1.02 um x ")
                .contains(
                        "light     coherence length 4.219 um (the scan's height less its overlap; 65 um in sunlight)",
                        "--periodic");
        inspectScan(0, " --explain --crop 2um:8um,1um:5um --level none --edges repeat");
        assertThat(out.toString())
                .contains("cropped from 10 um x 5 um", "5.938 um x 3.984 um, 76 x 51 samples")
                .doesNotContain("edges blended", "spike");
        inspectScan(0, " --explain --periodic");
        assertThat(out.toString()).doesNotContain("light     ").contains("levelling mean");
        inspectScan(0, " --explain --no-periodic");
        assertThat(out.toString()).contains("light     coherence length 4.219 um");
    }

    /** With a wrong unit the relief is too deep for any other command. */
    @Test
    void aScanThatCannotBeDrawnIsInspected() throws IOException {
        DoubleUnaryOperator wave = periods -> Math.sin(2 * Math.PI * periods);
        scan("scan.txt", "", 128, 64, (x, y) -> 500 * wave.applyAsDouble(x / 16) + 100 * wave.applyAsDouble(y / 13));
        inspectScan(0, " --explain --width 2mm");
        assertThat(err.toString()).doesNotContain("likely");
        assertThat(out.toString())
                .contains("size      2 mm x 1 mm", "plan      none;", "--coherence-length 65 um", "crop the patch")
                .doesNotContain("cost ");
        assertThat(ImageIO.read(folder.resolve("sheet.png").toFile()).getWidth())
                .isGreaterThan(1000);
        inspectScan(0, " --width 2mm --json");
        JsonNode report = new ObjectMapper().readTree(out.toString());
        assertThat(report.get("plan").isNull()).isTrue();
        assertThat(report.get("plan_refused").textValue()).contains("--coherence-length");
    }

    /** A relief in picometers shows no color, like a mirror. */
    @Test
    void aReliefFarBelowAWavelengthIsDoubtful() throws IOException {
        scan(0.1, false);
        inspectScan(3, "");
        assertThat(err.toString()).contains("the relief is only");
        assertThat(out.toString()).startsWith("A mirror: ");
        scan(2, false);
        inspectScan(0, "");
        assertThat(err.toString()).doesNotContain("mirror");
    }
}
