package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.files.input.PngText;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.optics.Gain;

final class EvaluateCommandTest extends CommandLineFixture {
    private static final int SAMPLES = 128;

    private int run(String options) {
        String wavelengths = options.contains("--wavelengths") ? "" : " --wavelengths 380:780:50";
        return sunbeam("evaluate --output @result " + options + wavelengths);
    }

    /** Evaluates a scan of this side; the function returns the height, nm, at a column and a row. */
    private int runScan(DoubleBinaryOperator height, double micrometers, String more) throws IOException {
        Path scan = scan("scan.txt", "", SAMPLES, SAMPLES, height);
        return run("--height-unit nm --force --patch " + scan + " --width " + micrometers + "um" + more);
    }

    private JsonNode report() throws IOException {
        return readJson("result.json");
    }

    private double nanometers(String field) throws IOException {
        return 1e9 * report().at(field).doubleValue();
    }

    @Test
    void aBlazedGratingHasItsPeriod() throws IOException {
        assertSuccess(run("--patch blaze --wavelengths 380:780:20 --explain"));
        JsonNode report = report();
        // The slope of the relative radiance shifts the peaks by 1.4e-4.
        assertThat(nanometers("/peaks_interpolated/mean_m")).isCloseTo(2500.3, within(0.3));
        assertThat(1e18 * report.at("/peaks_interpolated/variance_m2").doubleValue())
                .isLessThan(0.05);
        assertThat(report.at("/peaks_interpolated/wavelengths").intValue()).isEqualTo(21);
        assertThat(report.at("/azimuth_deg").doubleValue()).isZero();
        assertThat(nanometers("/period_m")).isCloseTo(2500, within(1e-6));
        // sin theta_r = lambda / d - sin 75, for 400 and 700 nm: order 1 of wr = -wi + m lambda / d.
        String verdict = "A repeated patch with a period of 2.5 um across 0 degrees: first-order colors at -54 to -43"
                + " degrees under light at 75 degrees";
        assertThat(out.toString())
                .startsWith(verdict)
                .contains("blaze, light at 75 degrees, azimuth 0 degrees", "2.5003 um", ", order 1:");
        assertThat(report.get("verdict").textValue()).startsWith(verdict);
        assertThat(folder.toFile().list()).contains("result.csv", "result.json", "result.png");
        String plan = report.at("/plan").textValue();
        assertThat(err.toString().lines()).contains("plan: " + plan);
        assertThat(PngText.read(folder.resolve("result.png"))).containsEntry("Plan", plan);
    }

    /** Text 000's Table 4.1 has 2500.34 nm and 0.16 nm2; steps of 0.01 degrees are 1.3 nm apart, whose square / 12 is 0.14. */
    @Test
    void theMaximaOfABlazedGratingHaveTheThesissMeanAndVariance() throws IOException {
        String options = "--azimuth 0 --wavelengths 380:780:20 --angles=-56:-40:0.01 --peaks maximum --patch blaze";
        assertSuccess(run(options + " --preset thesis --fresnel once"));
        assertThat(out.toString()).contains("maxima      2.500");
        // The standard error of 21 samples is 0.09 nm.
        assertThat(nanometers("/peaks_at_maxima/mean_m")).isCloseTo(2500.34, within(0.3));
        assertThat(1e18 * report().at("/peaks_at_maxima/variance_m2").doubleValue())
                .isCloseTo(0.16, within(0.1));
        assertThat(report().has("peaks_interpolated")).isFalse();
        // The thesis's published source takes the maxima of power: 2499.997 nm.
        assertThat(meanPeriodOfPower()).isCloseTo(2499.997, within(0.3));
    }

    /** Returns the mean over wavelengths of the period, nm, at which the response without its gain is largest. */
    private double meanPeriodOfPower() throws IOException {
        GratingPlane plane = new GratingPlane(Math.toRadians(75), 0, 0);
        double[] angles = Arrays.stream(
                        Files.readAllLines(folder.resolve("result.csv")).get(0).split(","))
                .mapToDouble(angle -> angle.startsWith("w") ? 0 : Double.parseDouble(angle))
                .toArray();
        return Arrays.stream(rows("result.csv"))
                .mapToDouble(row -> IntStream.range(1, row.length)
                        .boxed()
                        .max(Comparator.comparingDouble(
                                i -> row[i] / Gain.relativeRadiance(plane.pair(Math.toRadians(angles[i])))))
                        .map(i -> row[0] / Math.abs(plane.u(Math.toRadians(angles[i]))))
                        .orElseThrow())
                .average()
                .orElseThrow();
    }

    /** The shader's tolerance of 1e-3 in power moves a peak by thousandths of its width. */
    @ParameterizedTest
    @ValueSource(strings = {"full", "nmm", "pq", "reference"})
    void everyMethodSeesTheGrating(String method) throws IOException {
        String few = "--wavelengths 400:700:100 --angles -56:-42:0.15";
        assertSuccess(run(few + " --patch blaze --method " + method));
        double tolerance = method.equals("full") || method.equals("reference") ? 0.5 : 10;
        assertThat(nanometers("/peaks_interpolated/mean_m")).isCloseTo(2500.3, within(tolerance));
        assertThat(report().has("plan")).isEqualTo(!method.equals("reference"));
        assertThat(PngText.read(folder.resolve("result.png"))).containsEntry("Method", method);
    }

    @Test
    void aGivenPeriodIsLookedForInstead() throws IOException {
        // The second order of the blazed grating is the first order of half the period, which the heights do not have.
        assertThat(run("--patch blaze --azimuth 0 --period 1250nm"))
                .as(err.toString())
                .isEqualTo(4);
        assertThat(nanometers("/peaks_interpolated/mean_m")).isCloseTo(1250, within(0.5));
    }

    @ParameterizedTest
    @CsvSource({
        "--angles, -95:0:0.1, leaves the range -90 to 90 degrees",
        "--angles, 30:10:0.1, minimum",
        "--angles, -50:-40:0, step",
        "--angles, -50:-40:5, too coarse",
        "--angles, -50:-50:1, 3 or more",
        "--wavelengths, 380:780:0.01, too many",
        "--wavelengths, 300:700:5, leaves the range 380 to 780 nm",
        "--wavelengths, 400:900:5, leaves the range 380 to 780 nm",
        "--theta-i, 90, 89.9",
        "--azimuth, north, no angle",
        "--period, 5nm, out of range",
        "--theta-i, 75 --period 150nm, no angle sees the first order of a period near 150 nm",
        "--method, gem, 'use full, nmm, pq or reference'",
        "--method, table, 'use full, nmm, pq or reference'",
    })
    void whatCannotBeEvaluatedIsOneLine(String option, String value, String reason) throws IOException {
        assertThat(run("--patch blaze " + option + " " + value)).isEqualTo(2);
        assertThat(err.toString()).contains(option, reason).hasLineCount(1);
        assertThat(folder.toFile().list()).isEmpty();
    }

    /** The verdict stands where other patches have their result, in the words of inspect. */
    @Test
    void aPatchWithoutPeriodHasItsVerdictOnStandardOutput() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        assertThat(runScan((column, row) -> 60 * random.nextDouble(), 12.8, "")).isEqualTo(4);
        assertThat(out.toString())
                .startsWith("No order found: a white gloss without color")
                .hasLineCount(1);
        assertThat(err.toString()).contains("scan: no period is seen; to look for a ridge nevertheless, give --period");
        assertThat(folder.toFile().list()).containsExactly("scan.txt");
        String verdict = out.toString();
        forgetOutput();
        sunbeam("inspect @scan.txt --height-unit nm --width 12.8um --output @i.png");
        assertThat(out.toString()).startsWith(verdict);
    }

    @Test
    void tooFewPeriodsAreAProbableAnswer() throws IOException {
        DoubleBinaryOperator lines = (column, row) -> 0.1 * column % 3.8 < 1.6 ? 100 : 0;
        assertSuccess(runScan(lines, 11, " --no-periodic"));
        assertThat(out.toString())
                .containsPattern(
                        "Probably a grating of about 3\\.[23] um \\(3\\.[34] periods seen, too few for an interval\\)");
        assertSuccess(runScan(lines, 11, " --no-periodic --azimuth 0 --period 3.3um"));
        assertThat(out.toString()).contains("period      probably about 3.");
        assertThat(report().get("period_m").isNull()).isTrue();
        assertThat(report().get("period_not_told").textValue()).contains("too few for an interval");
        assertThat(report().get("verdict_code").textValue()).isEqualTo("probable_grating");
    }

    /** Overlapping orders would give a ridge at 43 um for a period of 50 um. */
    @Test
    void ordersThatLightDoesNotTellApartHaveNoRidge() throws IOException {
        String few = "--wavelengths 400:700:100 --angles -80:-70:0.2 --azimuth 0";
        assertSuccess(runScan((column, row) -> 150 * Math.sin(2 * Math.PI * column * 10 / SAMPLES), 500, " " + few));
        assertThat(out.toString())
                .contains(
                        "period      50",
                        "left out: light with a coherence length of 65 um sees a period of about 50 um 1.3 times",
                        "--coherence-length 96 um or more does");
        assertThat(nanometers("/period_m")).isCloseTo(50e3, within(50.0));
        assertThat(report().get("ridge_left_out").textValue()).contains("too few to tell its orders apart");
        assertThat(report().has("peaks_interpolated")).isFalse();
        assertThat(folder.toFile().list()).contains("result.csv", "result.png");
    }

    /** At 75 degrees the order of 291 nm is seen up to 572 nm. */
    @Test
    void aShortPeriodIsLookedAtWhereItIsSeen() throws IOException {
        assertSuccess(runScan(
                (column, row) -> 15 * Math.sin(2 * Math.PI * column * 50 / 291.0), 6.4, " --wavelengths 380:780:20"));
        assertThat(report().at("/peaks_interpolated/wavelengths").intValue()).isBetween(8, 13);
        assertThat(nanometers("/period_low_m")).isLessThan(291.1);
        assertThat(nanometers("/period_high_m")).isGreaterThan(290.9);
    }
}
