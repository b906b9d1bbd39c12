package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.input.PngText;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.ExitCode;

@NeedsDisplay
class ColorCommandTest extends CommandLineFixture {
    private int run(String options) {
        forgetOutput();
        String window = options.contains("--coherence-length") ? "" : " --coherence-length 10um";
        return sunbeam("color --output @c.png --force " + options + window);
    }

    private JsonNode tell(String options) throws IOException {
        assertSuccess(run(options));
        return readJson("c.json");
    }

    private JsonNode surface(String options) throws IOException {
        return tell(options).get("surfaces").get(0);
    }

    private static JsonNode at(JsonNode surface, String strip, double theta) {
        return StreamSupport.stream(surface.get("colors").spliterator(), false)
                .filter(color -> color.get("strip").asText().equals(strip))
                .filter(color -> Math.abs(number(color, "theta_r_deg") - theta) < 1e-9)
                .findFirst()
                .orElseThrow();
    }

    private static double number(JsonNode fields, String name) {
        return fields.get(name).asDouble();
    }

    @Test
    void aGratingsColorIsThatOfItsFirstOrder() throws IOException {
        JsonNode surface = surface("--patch sinusoid --theta-i 0");
        assertThat(number(surface, "plane_azimuth_deg")).isCloseTo(0, within(0.01));
        JsonNode spectrum = surface.get("spectrum");
        double theta = number(spectrum, "theta_r_deg");
        // lambda = d sin(theta) for a period of 2.5 um.
        double expected = 2500 * Math.sin(Math.toRadians(Math.abs(theta)));
        double width = 1e9 * number(spectrum, "width_m");
        JsonNode green = at(surface, "along", 12);
        // The eye weighs the longer half of the order's band more, which shifts the hue by a width at most.
        assertThat(1e9 * number(green, "dominant_m")).isCloseTo(2500 * Math.sin(Math.toRadians(12)), within(width));
        JsonNode radiance = spectrum.get("relative_radiance");
        int brightest = IntStream.range(0, radiance.size())
                .reduce(
                        0,
                        (a, b) -> radiance.get(b).asDouble() > radiance.get(a).asDouble() ? b : a);
        // The order's height falls with its wavelength, which shifts the maximum by part of its width.
        assertThat(1e9 * spectrum.get("wavelength_m").get(brightest).asDouble()).isCloseTo(expected, within(width / 2));
        assertThat(number(green, "delta_e")).as("tolerance 1e-3").isBetween(1e-3, 1.0);
    }

    /** The mirror's direction and orders that the end of a step cuts. */
    @Test
    void theMeanOverAStepIsThatOfItsParts() throws IOException {
        JsonNode whole = surface("--patch blaze --theta-i 30 --angles -55:-25:2 --coherence-length 65um");
        JsonNode parts = surface("--patch blaze --theta-i 30 --angles -55.9:-24.1:0.2 --coherence-length 65um");
        for (double theta = -55; theta <= -25; theta += 2) {
            double middle = theta;
            double mean = IntStream.range(0, 10)
                    .mapToDouble(i -> number(at(parts, "along", middle - 0.9 + 0.2 * i), "Y"))
                    .average()
                    .orElseThrow();
            // Colors are planned to 1e-3, rules of both steps to 2e-4 of a cut order.
            assertThat(number(at(whole, "along", theta), "Y")).as("%s", theta).isCloseTo(mean, within(3e-3 * mean));
        }
    }

    @Test
    void theMirrorDirectionIsWhiteWhateverTheConstantIndex() throws IOException {
        String grating = "--patch sinusoid --theta-i 0 --index ";
        double glass = number(at(surface(grating + 1.5), "along", 0), "Y");
        // Colors are relative to a mirror of the same index, whose reflectance along the normal is Schlick's.
        for (String index : new String[] {"1.56", "0.97+6.5i"}) {
            assertThat(number(at(surface(grating + index), "along", 0), "Y")).isCloseTo(glass, within(1e-6 * glass));
        }
    }

    @Test
    void thePurestColorLiesBesideTheGlossWhateverTheExposure() throws IOException {
        String light = "--patch sinusoid --theta-i 30";
        JsonNode told = tell(light);
        assertThat(told.get("light").asText()).isEqualTo("theta 30 degrees, phi that of each strip's plane");
        JsonNode surface = told.get("surfaces").get(0);
        assertThat(1e6 * number(surface, "coherence_length_m")).isCloseTo(10, within(1e-9));
        JsonNode purest = surface.get("purest");
        // Five deviations of the spectrum of a window of 10 um, at 780 nm.
        double reach = 5 * 2 / (Math.PI * 10e-6) * 780e-9;
        double u = Math.sin(Math.toRadians(30)) + Math.sin(Math.toRadians(number(purest, "theta_r_deg")));
        assertThat(Math.abs(u)).isGreaterThan(reach);
        double brighter = 1000 * number(told, "exposure");
        JsonNode same = surface(light + " --exposure " + brighter).get("purest");
        assertThat(same.get("theta_r_deg")).isEqualTo(purest.get("theta_r_deg"));
        assertThat(same.get("purity")).isEqualTo(purest.get("purity"));
    }

    /** The surface has waves 4 um long and, at right angles, steeper ones 1.3 um long. */
    @Test
    void ofCrossedGratingsEitherHasItsColorsInAStrip() throws IOException {
        double turns = 2 * Math.PI * 20 / 128;
        Path scan = scan(
                "crossed.txt",
                "",
                128,
                128,
                (column, row) -> 40 * Math.cos(turns * column / 4) + 30 * Math.cos(turns * row / 1.3));
        String crossed = "--patch " + scan + " --width 20um --height-unit nm --theta-i 30 --no-periodic";
        JsonNode surface = surface(crossed);
        for (int strip = 0; strip < 2; strip++) {
            // lambda = d (sin(30) + sin(theta_r)) for the first order at 550 nm.
            double theta = Math.rint(Math.toDegrees(Math.asin(0.55 / (strip == 0 ? 4 : 1.3) - 0.5)));
            JsonNode green = at(surface, strip == 0 ? "along" : "across", theta);
            assertThat(number(green, "phi_deg")).isCloseTo(90 * strip, within(0.5));
            assertThat(green.get("phi_i_deg")).isEqualTo(green.get("phi_deg"));
            // A window of 10 um makes an order at least 70 nm wide; the hue lies within the order.
            assertThat(1e9 * number(green, "dominant_m")).isCloseTo(550, within(50.0));
            assertThat(number(green, "lightness")).as("as bright as a color").isGreaterThan(20);
        }
        // The orders of the finer waves are separate; those of the coarser waves overlap.
        assertThat(surface.get("purest").get("strip").asText()).isEqualTo("across");
        assertThat(out.toString()).contains("degrees (across): ").doesNotContain("beside both planes");
        tell(crossed + " --phi-i 45");
        assertThat(out.toString()).contains("beside both planes");
    }

    /** Lines 9.14 um apart, whose orders are narrower than a degree in sunlight. */
    private String wideLines(double nanometers) throws IOException {
        Path scan = scan("wide.txt", "", 128, 4, (column, row) -> nanometers * Math.sin(2 * Math.PI * column / 128.0));
        String options = " --width 9.14um --height-unit nm --periodic --theta-i 0 --coherence-length 65um";
        return "--patch " + scan + options;
    }

    @Test
    void aColorIsTheMeanOverAStepOfTheAngles() throws IOException {
        String lines = wideLines(100);
        JsonNode coarse = surface(lines + " --angles 2:10:1");
        JsonNode fine = surface(lines + " --angles 1.6:10.4:0.2");
        double brightest = IntStream.rangeClosed(2, 10)
                .mapToDouble(degrees -> number(at(coarse, "along", degrees), "Y"))
                .max()
                .orElseThrow();
        for (int degrees = 2; degrees <= 10; degrees++) {
            double mean = 0;
            for (int part = -2; part <= 2; part++) {
                mean += number(at(fine, "along", degrees + 0.2 * part), "Y") / 5;
            }
            // Means over steps of 1.5 deviations and over finer steps differ by at most 3e-3 of the brightest.
            assertThat(number(at(coarse, "along", degrees), "Y")).isCloseTo(mean, within(3e-3 * brightest));
        }
        assertThat(run(lines + " --angles 0:89.9:1")).isEqualTo(ExitCode.USAGE.code());
        assertThat(err.toString()).contains("--angles").hasLineCount(1);
    }

    /** 0.4 and 0.7 um over 9.14 um: 2.5 to 4.4 degrees; second orders hold a hundredth of the light of the first. */
    @Test
    void theGlossLeavesALongPeriodsFirstOrderItsColors() throws IOException {
        JsonNode purest = surface(wideLines(20)).get("purest");
        assertThat(Math.abs(number(purest, "theta_r_deg"))).isBetween(2.5, 5.0);
    }

    /** Samples 300 nm apart repeat each order: beyond |u| = 0.38 / 0.6 colors are images of it. */
    @Test
    void thePurestColorIsInAnOrderOfTheGratingNotInAnImageByTheSamples() throws IOException {
        Path scan = scan(
                "coarse.txt", "", 80, 80, (column, row) -> 30 * Math.sin(2 * Math.PI * (column + 0.01 * row) / 10));
        JsonNode purest = surface("--patch " + scan + " --width 24um --height-unit nm --no-periodic --theta-i 30")
                .get("purest");
        assertThat(purest.get("strip").asText()).isEqualTo("along");
        double u = 0.5 + Math.sin(Math.toRadians(number(purest, "theta_r_deg")));
        // From 400 nm in the first order to 700 nm in the second of 3 um, 5 % wider, and half a degree.
        assertThat(Math.abs(u)).isBetween(0.4 / 3 / 1.05 - 0.01, 1.4 / 3 * 1.05 + 0.01);
    }

    @Test
    void theFirstLineIsAVerdict() throws IOException {
        tell("--patch sinusoid --coherence-length 40um");
        // asin(0.4 / 2.5) and asin(0.7 / 2.5).
        assertThat(out.toString().lines().findFirst().orElseThrow())
                .isEqualTo("A repeated patch with a period of 2.5 um across 0 degrees: first-order colors at 9 to 16"
                        + " degrees under light from above");
        assertThat(out.toString().lines().count() + err.toString().lines().count())
                .isLessThanOrEqualTo(8);
        assertThat(err.toString()).as("without --explain").doesNotContain("plan:");
        tell("--patch blaze --theta-i 20 --phi-i 180 --coherence-length 65um");
        assertThat(out.toString())
                .contains(
                        "at 4 to 10 degrees under light at 20 degrees, turned by 180 degrees",
                        "54 degrees (second order)");
        run("--patch sinusoid --theta-i 30 --phi-i 90");
        assertThat(out.toString()).startsWith("No color is seen: the orders lie beside both planes (give no --phi-i)");
        tell("--patch sinusoid --explain");
        assertThat(err.toString()).contains("plan: sinusoid: ");
    }

    @Test
    void aSurfaceWithoutOrderHasNoColorAndDoesNotDarkenOthers() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        Path noise = scan("noise.txt", "", 128, 128, (column, row) -> 20 * random.nextGaussian());
        Path lines = scan("lines.txt", "", 128, 128, (column, row) -> 60 * Math.sin(2 * Math.PI * column / 12.8));
        String scale = " --width 20um --height-unit nm";
        assertThat(run("--patch " + noise + scale)).isEqualTo(ExitCode.TOLERANCE_MISSED.code());
        assertThat(out.toString())
                .startsWith("No order found: a white gloss without color")
                .doesNotContain("purest");
        assertThat(readJson("c.json").get("surfaces").get(0).toString())
                .contains("\"purest\":null", "\"has_color\":false");
        double alone = number(tell("--patch " + lines + scale), "exposure");
        run("--patch " + lines + scale + " --with " + noise);
        assertThat(number(readJson("c.json"), "exposure")).isEqualTo(alone);
    }

    @Test
    void aScanOfAWavelengthTellsNoColor() throws IOException {
        String scan = "--patch sinusoid --no-periodic --crop 0um:0.5um,0um:0.5um";
        assertThat(run(scan)).isEqualTo(ExitCode.TOLERANCE_MISSED.code());
        assertThat(out.toString()).startsWith("Too little to judge: a side of 508 nm");
        assertThat(readJson("c.json").get("warnings"))
                .extracting(JsonNode::asText)
                .anyMatch(line -> line.contains("coherence length 507.8 nm (the scan's width; 10 um asked)"));
        assertThat(readJson("c.json").get("surfaces").get(0).get("model").asText())
                .contains("docs/theory.md");
    }

    /** Uses files of instruments that are not part of the project. */
    @ParameterizedTest
    @CsvSource({"scans/nid-1.nid, 3, No order found", "scans/di-1.di, 3, Too little to judge"})
    void measuredSurfacesHaveTheirVerdict(String file, int code, String verdict) throws IOException {
        Path scan = Path.of("../../shared", file);
        assumeTrue(Files.exists(scan), scan + " is missing: what color says of it is not tested");
        assertThat(run("--patch " + scan + " --coherence-length 65um")).isEqualTo(code);
        assertThat(out.toString()).startsWith(verdict);
        assertThat(err.toString().lines().filter(line -> line.contains("warning:")))
                .as("warnings")
                .hasSizeLessThanOrEqualTo(1);
    }

    @Test
    void aTabulatedIndexColorsTheLightAndAConstantOneInAFileDoesNot() throws IOException {
        Path same = Files.writeString(folder.resolve("same.csv"), "wl,n\n0.3,1.56\n0.9,1.56\n\nwl,k\n0.3,0\n0.9,0\n");
        Path gold = Files.writeString(
                folder.resolve("gold.csv"), "wl,n,k\n0.3,1.5,1.9\n0.5,1.0,1.9\n0.6,0.25,3.0\n0.8,0.15,4.9\n");
        String light = "--patch sinusoid --theta-i 20";
        JsonNode constant = surface(light + " --index 1.56");
        JsonNode table = surface(light + " --index " + same);
        JsonNode golden = surface(light + " --index " + gold);
        for (double theta : new double[] {-40, -20, -8, 10, 60}) {
            for (String channel : new String[] {"X", "Y", "Z"}) {
                double expected = number(at(constant, "along", theta), channel);
                // Results are float32, written with seven digits.
                assertThat(number(at(table, "along", theta), channel))
                        .isCloseTo(expected, within(1e-5 * Math.abs(expected)));
            }
        }
        assertThat(PngText.read(folder.resolve("c.png")))
                .containsEntry("Index", "gold.csv, tabulated from 300 to 800 nm");
        assertThat(1e9 * number(at(golden, "along", -20), "dominant_m"))
                .as("gold")
                .isBetween(570.0, 610.0);
    }

    @Test
    void severalSurfacesShareOneExposure() throws IOException {
        JsonNode told = tell("--patch blaze --with lamellar --theta-i 0");
        assertThat(told.get("surfaces")).hasSize(2);
        // 2 strips of 161 angles.
        assertThat(told.get("surfaces").get(1).get("colors")).hasSize(2 * 161);
        assertThat(Files.readAllLines(folder.resolve("c.csv"))).hasSize(1 + 2 * 2 * 161);
        assertThat(told.get("light").asText()).startsWith("theta 0 degrees, phi that of each");
        assertThat(PngText.read(folder.resolve("c.png")))
                .containsEntry("Exposure", told.get("exposure").toString())
                .containsEntry("Index", "1.5");
    }

    @ParameterizedTest
    @CsvSource({
        "glass, USAGE, --index",
        "0, USAGE, --index",
        "1, USAGE, reflects nothing",
        "-1.5, USAGE, --index",
        "@infrared.csv, UNUSABLE_INPUT, from 1000 to 5000 nm",
        "@words.csv, UNUSABLE_INPUT, line 2: ",
        "@none.csv, UNUSABLE_INPUT, none.csv"
    })
    void whatIsNoIndexIsRefused(String index, ExitCode code, String words) throws IOException {
        Files.writeString(folder.resolve("infrared.csv"), "wl,n\n1,1.5\n5,1.4\n");
        Files.writeString(folder.resolve("words.csv"), "wl,n\n0.3,glass\n");
        assertComplaint(code, "color --output @c.png --index " + index, words);
        assertThat(folder.resolve("c.png")).doesNotExist();
    }
}
