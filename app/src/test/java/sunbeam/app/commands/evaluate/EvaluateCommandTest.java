package sunbeam.app.commands.evaluate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.Sunbeam;
import sunbeam.app.files.input.PngText;
import sunbeam.app.terminal.Environment;

/** Method {@code bins}, without graphics, where a test does not name another. */
final class EvaluateCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        List<String> all = new ArrayList<>(List.of("evaluate"));
        all.addAll(List.of(arguments));
        if (!all.contains("--method")) {
            all.addAll(List.of("--method", "bins"));
        }
        if (!all.contains("--wavelengths")) {
            all.addAll(List.of("--wavelengths", "380:780:20"));
        }
        all.addAll(List.of("--output", folder.resolve("result").toString()));
        Environment environment = new Environment(Map.of(), folder);
        return new Sunbeam(environment, new PrintWriter(out), new PrintWriter(err)).run(all.toArray(String[]::new));
    }

    private JsonNode report() throws IOException {
        return new ObjectMapper().readTree(folder.resolve("result.json").toFile());
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void aBlazedGratingHasItsPeriod() throws IOException {
        assertThat(run("--patch", "blaze")).as(err.toString()).isZero();
        JsonNode report = report();
        // Of the relative radiance, whose slope draws the peaks aside by 1.4e-4 (docs/evaluation.md).
        assertThat(report.at("/peaks_interpolated/mean_nm").doubleValue()).isCloseTo(2500.3, within(0.3));
        assertThat(report.at("/peaks_interpolated/variance_nm2").doubleValue()).isLessThan(0.05);
        assertThat(report.at("/peaks_on_samples/variance_nm2").doubleValue()).isBetween(0.05, 0.5);
        assertThat(report.at("/peaks_interpolated/wavelengths").intValue()).isEqualTo(21);
        assertThat(report.at("/azimuth_degrees").doubleValue()).isZero();
        assertThat(report.at("/period/nm").doubleValue()).isCloseTo(2500, within(1e-6));
        assertThat(out.toString())
                .startsWith(
                        "A repeated patch with a period of 2.5 um across 0 degrees: first-order colors at 9 to 16 degrees")
                .contains("blaze, light at 75 degrees, azimuth 0 degrees", "2.5003 um");
        assertThat(files()).containsExactly("result.csv", "result.json", "result.npy", "result.png");
    }

    @ParameterizedTest
    @ValueSource(strings = {"full", "nmm", "pq"})
    void thePlanStandsInTheFigures(String method) throws IOException {
        String[] few = {"--wavelengths", "400:700:100", "--angles", "-56:-42:0.15"};
        assertThat(run(Stream.concat(Stream.of("--patch", "blaze", "--method", method, "--explain"), Stream.of(few))
                        .toArray(String[]::new)))
                .as(err.toString())
                .isZero();
        String plan = report().at("/plan").textValue();
        assertThat(err.toString().lines()).contains("plan: " + plan);
        assertThat(PngText.read(folder.resolve("result.png"))).containsEntry("Plan", plan);
    }

    @ParameterizedTest
    @ValueSource(strings = {"bins", "reference"})
    void whereNothingIsPlannedThereIsNoPlan(String method) throws IOException {
        String[] few = {"--wavelengths", "400:700:100", "--angles", "-56:-42:0.15"};
        assertThat(run(Stream.concat(Stream.of("--patch", "blaze", "--method", method), Stream.of(few))
                        .toArray(String[]::new)))
                .as(err.toString())
                .isZero();
        assertThat(report().has("plan")).isFalse();
        assertThat(PngText.read(folder.resolve("result.png")))
                .containsEntry("Method", method)
                .doesNotContainKey("Plan");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "gem|gem has colors but no power at a wavelength, so there is no response to evaluate",
                "magic|is no method; give"
            })
    void aMethodWithoutResponseIsRefused(String method, String reason) throws IOException {
        assertThat(run("--patch", "blaze", "--method", method)).isEqualTo(2);
        assertThat(err.toString())
                .contains("--method", reason, "give one of reference, full, nmm, pq, bins")
                .hasLineCount(1);
        assertThat(files()).isEmpty();
    }

    @Test
    void powerAloneDrawsThePeaksLessAside() throws IOException {
        assertThat(run("--patch", "blaze", "--quantity", "power")).isZero();
        assertThat(report().at("/peaks_interpolated/mean_nm").doubleValue()).isCloseTo(2500, within(0.1));
    }

    @Test
    void theMatrixIsWrittenWithItsAxes() throws IOException {
        assertThat(run("--patch", "sinusoid", "--angles", "-56:-38:0.15"))
                .as(err.toString())
                .isZero();
        List<String> lines = Files.readAllLines(folder.resolve("result.csv"));
        assertThat(lines).hasSize(1 + 21);
        assertThat(lines.get(0))
                .startsWith("wavelength_nm,-56.000000,-55.850000,")
                .endsWith(",-38.000000");
        assertThat(lines.get(1))
                .startsWith("3.800000000000e+02,")
                .satisfies(line -> assertThat(line.split(",")).hasSize(122));
        // 128 bytes of header, then float32.
        assertThat(Files.size(folder.resolve("result.npy"))).isEqualTo(128 + 4 * 21 * 121);
        assertThat(report().at("/angles_degrees/count").intValue()).isEqualTo(121);
        assertThat(ImageIO.read(folder.resolve("result.png").toFile()).getWidth())
                .isGreaterThan(800);
    }

    @Test
    void positionsAreDrawnBySeedAndTold() throws IOException {
        // Strips of one grating: every position sees the same period.
        assertThat(run("--patch", "sinusoid", "--positions", "5", "--seed", "3"))
                .as(err.toString())
                .isZero();
        JsonNode positions = report().at("/positions");
        assertThat(positions.at("/with_a_ridge").intValue()).isEqualTo(5);
        assertThat(positions.at("/maximum_nm").doubleValue())
                .isCloseTo(positions.at("/minimum_nm").doubleValue(), within(0.01));
        assertThat(positions.at("/ensemble_nm").doubleValue())
                .isCloseTo(positions.at("/median_nm").doubleValue(), within(0.01));
        List<String> first = Files.readAllLines(folder.resolve("result-positions.csv"));
        assertThat(run("--patch", "sinusoid", "--positions", "5", "--seed", "3", "--force"))
                .isZero();
        assertThat(Files.readAllLines(folder.resolve("result-positions.csv")))
                .isEqualTo(first)
                .hasSize(6);
        assertThat(files()).contains("result-positions.png");
    }

    @Test
    void aGivenPeriodIsLookedForInstead() throws IOException {
        // The second order of the blazed grating, as if it were the first of half the period: no period of the heights.
        assertThat(run("--patch", "blaze", "--azimuth", "0", "--period", "1250nm"))
                .as(err.toString())
                .isEqualTo(4);
        assertThat(report().at("/peaks_interpolated/mean_nm").doubleValue()).isCloseTo(1250, within(0.5));
    }

    @ParameterizedTest
    @CsvSource({
        "--angles, -95:0:0.1, hemisphere",
        "--angles, 30:10:0.1, minimum",
        "--angles, -50:-40:0, step",
        "--angles, -50:-40:5, too coarse",
        "--angles, -50:-50:1, 3 or more",
        "--wavelengths, 300:700:5, visible band",
        "--wavelengths, 400:900:5, visible band",
        "--wavelengths, 400:400:5, 3 or more",
        "--theta-i, 90, 89.9",
        "--azimuth, north, no angle",
        "--period, 5nm, out of range",
        "--positions, -1, out of range",
    })
    void whatCannotBeEvaluatedIsOneLine(String option, String value, String reason) throws IOException {
        assertThat(run("--patch", "blaze", option, value)).isEqualTo(2);
        assertThat(err.toString()).contains(option, reason).hasLineCount(1);
        assertThat(files()).isEmpty();
    }

    @Test
    void aPatchWithoutPeriodGivesItsFigureInsteadOfANumber() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        BufferedImage image = new BufferedImage(300, 300, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 90_000; i++) {
            image.getRaster().setSample(i % 300, i / 300, 0, random.nextInt(256));
        }
        File noise = folder.resolve("noise.png").toFile();
        ImageIO.write(image, "png", noise);
        String[] patch = {"--patch", noise.toString(), "--width", "25um", "--max-height", "60nm"};
        assertThat(run(patch)).isEqualTo(4);
        assertThat(err.toString()).contains("noise: no order found: a white gloss without color", "--period");
        assertThat(files()).containsExactly("noise.png");
    }

    @Test
    void tooFewPeriodsAreNoAnswer() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 128 * 128; i++) {
            text.append(0.1 * (i % 128) % 3.8 < 1.6 ? 100 : 0).append(i % 128 == 127 ? "\n" : "\t");
        }
        Path scan = Files.writeString(folder.resolve("scan.txt"), text);
        String[] patch = {"--patch", scan.toString(), "--width", "11um", "--height-unit", "nm", "--no-periodic"};
        assertThat(run(patch)).isEqualTo(4);
        assertThat(err.toString())
                .contains("no order found for sure: a wave of about 3.", "take a larger scan; to look for");
        assertThat(run(Stream.concat(Stream.of(patch), Stream.of("--azimuth", "0", "--period", "3.3um"))
                        .toArray(String[]::new)))
                .as(err.toString())
                .isEqualTo(4);
        assertThat(out.toString()).startsWith("No order found for sure: ").contains("period      not told: ");
        assertThat(report().get("period").isNull()).isTrue();
        assertThat(report().get("period_not_told").textValue()).contains("no order found for sure");
    }

    /** 1 mm of a 50 um grating took a quarter of an hour for a ridge at 43 um under a right period. */
    @Test
    void ordersThatLightDoesNotTellApartHaveNoRidge() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 96 * 96; i++) {
            text.append(150 * Math.sin(2 * Math.PI * (i % 96) * 5 / 50.0)).append(i % 96 == 95 ? "\n" : "\t");
        }
        Path scan = Files.writeString(folder.resolve("scan.txt"), text);
        String[] patch = {"--patch", scan.toString(), "--width", "480um", "--height-unit", "nm", "--azimuth", "0"};
        String[] few = {"--wavelengths", "400:700:100", "--angles", "-80:-70:0.2", "--positions", "2"};
        assertThat(run(Stream.of(patch, few).flatMap(Stream::of).toArray(String[]::new)))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .contains(
                        "period      50",
                        "left out: light with a coherence length of 65 um sees a period of about 50 um 1.3 times",
                        "--coherence-length 96 um or more does")
                .doesNotContain("standard error", "NaN");
        assertThat(report().at("/period/nm").doubleValue()).isCloseTo(50e3, within(50.0));
        assertThat(report().get("ridge_left_out").textValue()).contains("too few to tell its orders apart");
        assertThat(report().has("peaks_interpolated")).isFalse();
        assertThat(files()).contains("result.csv", "result.npy", "result.png");
    }

    @Test
    void alongTheRidgesThereIsNoPeriod() throws IOException {
        assertThat(run("--patch", "blaze", "--azimuth", "90")).isEqualTo(4);
        assertThat(err.toString())
                .contains(
                        "blaze: no order found: a white gloss without color; nothing repeats along azimuth 90 degrees");
        assertThat(files()).isEmpty();
    }

    @Test
    void anOrderThatNoAngleSeesIsSaid() {
        assertThat(run("--patch", "sinusoid", "--period", "150nm")).isEqualTo(2);
        assertThat(err.toString())
                .contains(
                        "no angle sees the first order of a period near 150 nm",
                        "is seen up to 295 nm",
                        "beyond 300 nm")
                .hasLineCount(1);
    }

    /** Of 291 nm it was said that no angle sees it; at 75 degrees it is seen up to 572 nm. */
    @Test
    void aShortPeriodIsLookedAtWhereItIsSeen() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 128 * 128; i++) {
            text.append(15 * Math.sin(2 * Math.PI * (i % 128) * 50 / 291.0)).append(i % 128 == 127 ? "\n" : "\t");
        }
        Path scan = Files.writeString(folder.resolve("scan.txt"), text);
        assertThat(run("--patch", scan.toString(), "--width", "6.4um", "--height-unit", "nm"))
                .as(err.toString())
                .isZero();
        assertThat(err.toString())
                .contains("is seen up to 572 nm with the light at --theta-i 75", "the 10 of 21 wavelengths")
                .doesNotContain("the scan is large");
        assertThat(report().at("/wavelengths_nm/last").doubleValue()).isCloseTo(560, within(1e-6));
        assertThat(report().at("/period/low_nm").doubleValue()).isLessThan(291.1);
        assertThat(report().at("/period/high_nm").doubleValue()).isGreaterThan(290.9);
    }

    /** One judgement, in the words of {@code inspect}: the gaps of a chirp differ by half from end to end. */
    @Test
    void whatIsNoSinglePeriodIsRefusedAsByInspect() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 128 * 128; i++) {
            double x = 0.1 * (i % 128);
            text.append(15 * Math.sin(2 * Math.PI * (x / 0.8 - 0.025 * x * x))).append(i % 128 == 127 ? "\n" : "\t");
        }
        String[] scale = {"--width", "12.8um", "--height-unit", "nm"};
        Path chirp = Files.writeString(folder.resolve("chirp.txt"), text);
        assertThat(run(Stream.concat(Stream.of("--patch", chirp.toString()), Stream.of(scale))
                        .toArray(String[]::new)))
                .isEqualTo(4);
        assertThat(err.toString()).contains("chirp: no single period: ", "; to look for a ridge");
        StringWriter inspected = new StringWriter();
        String[] inspect = {
            "inspect", chirp.toString(), "--output", folder.resolve("i.png").toString()
        };
        new Sunbeam(new Environment(Map.of(), folder), new PrintWriter(inspected), new PrintWriter(new StringWriter()))
                .run(Stream.concat(Stream.of(inspect), Stream.of(scale)).toArray(String[]::new));
        String verdict = inspected.toString().lines().findFirst().orElseThrow();
        assertThat(verdict).startsWith("No single period: ");
        assertThat(err.toString()).contains(verdict.substring(1));
    }

    @Test
    void filesThatExistStay() {
        assertThat(run("--patch", "blaze")).isZero();
        assertThat(run("--patch", "blaze")).isEqualTo(8);
        assertThat(err.toString()).contains("--force");
    }

    @Test
    void resumeLeavesWhatWasMadeAlikeAndRefusesTheRest() throws IOException {
        assertThat(run("--patch", "blaze", "--resume")).as(err.toString()).isZero();
        Path picture = folder.resolve("result.png");
        FileTime made = FileTime.fromMillis(1_000_000);
        Files.setLastModifiedTime(picture, made);

        assertThat(run("--patch", "blaze", "--resume")).as(err.toString()).isZero();
        assertThat(Files.getLastModifiedTime(picture)).isEqualTo(made);
        assertThat(run("--patch", "blaze", "--resume", "--theta-i", "60")).isEqualTo(8);
    }

    /** Three wavelengths, the longest at the horizon: "no ridge (the heights: 1e9 times above its surroundings, 100 are needed)". */
    @Test
    void fewWavelengthsLeaveTheRidgeOutAndNotThePeriod() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 128 * 128; i++) {
            text.append(15 * Math.sin(2 * Math.PI * (i % 128) * 50 / 250.0)).append(i % 128 == 127 ? "\n" : "\t");
        }
        Path scan = Files.writeString(folder.resolve("scan.txt"), text);
        String[] coarse = {"--patch", scan.toString(), "--width", "6.4um", "--height-unit", "nm", "--wavelengths"};
        assertThat(run(Stream.concat(Stream.of(coarse), Stream.of("380:780:50")).toArray(String[]::new)))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .contains(
                        "period      250", "left out: the response has no ridge of periods from 185 nm to 337 nm at 3");
        assertThat(report().at("/period/nm").doubleValue()).isCloseTo(250, within(0.5));
        assertThat(run(Stream.concat(Stream.of(coarse), Stream.of("380:780:100", "--force"))
                        .toArray(String[]::new)))
                .isEqualTo(2);
        assertThat(err.toString()).contains("finer steps of --wavelengths");
    }
}
