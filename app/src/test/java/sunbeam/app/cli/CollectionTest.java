package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;

final class CollectionTest extends CollectionFixture {
    /** The first waits for the second, and ends after it. */
    @Test
    void twoSurfacesAreMadeAtOnceAndTheirRowsKeepTheirOrder() throws IOException {
        CompletableFuture<Void> second = new CompletableFuture<Void>().orTimeout(20, TimeUnit.SECONDS);
        Collection collection = Collection.of(
                        new CommandLine(new InspectCommand())
                                .parseArgs("disc", "blaze", "lamellar", "--output", report.toString()),
                        words -> {
                            if (words.contains("--patch=disc")) {
                                second.join();
                            }
                            second.complete(null);
                            return new Collection.Outcome(0, "{}", "");
                        })
                .orElseThrow();

        collection.run(new PrintWriter(out), new PrintWriter(err), new Environment(Map.of(), folder).progress());

        assertThat(column("file")).containsExactly("disc", "blaze", "lamellar");
    }

    @Test
    void aFolderBecomesOneTableAndOneSheet() throws IOException {
        scan("other.txt", x -> 40 * Math.sin(2 * Math.PI * x / (2 * PERIOD)));

        assertSuccess(inspect("@scans"));

        List<NamedCsvRecord> rows = table("table.csv");
        assertThat(column("file"))
                .containsExactly(
                        scans.resolve("grating.txt").toString(),
                        scans.resolve("other.txt").toString());
        NamedCsvRecord row = rows.get(0);
        assertThat(row.getField("verdict_code")).isEqualTo("sure_grating");
        assertThat(Double.parseDouble(row.getField("period_low_m"))).isLessThan(PERIOD);
        assertThat(Double.parseDouble(row.getField("period_high_m"))).isGreaterThan(PERIOD);
        // First orders of 2 um lie at asin(0.4 / 2) = 11.5 to asin(0.7 / 2) = 20.5 degrees, wider by the interval.
        assertThat(row.getField("first_orders_deg"))
                .matches("1[01]\\.\\d+ to 2[01]\\.\\d+; -1[01]\\.\\d+ to -2[01]\\.\\d+");
        assertThat(Double.parseDouble(row.getField("width_m"))).isCloseTo(16e-6, within(1e-20));
        assertThat(row.getField("columns")).isEqualTo("64");
        // A sine's deviation: its amplitude over sqrt(2).
        assertThat(Double.parseDouble(row.getField("roughness_m"))).isCloseTo(50e-9 / Math.sqrt(2), within(1e-9));
        assertThat(row.getField("warnings")).contains("constant along one axis", "; sampling too coarse: samples are");
        BufferedImage sheet = ImageIO.read(report.resolve("sheet.png").toFile());
        // Two thumbnails with black and white stripes lie side by side; the sheet is empty to the right of them.
        assertThat(darkest(sheet, 16, 300)).isLessThan(80);
        assertThat(darkest(sheet, 316, 600)).isLessThan(80);
        assertThat(darkest(sheet, 620, 900)).isGreaterThan(250);
        assertThat(out.toString()).startsWith("2 surfaces: ").contains("table.csv", "sheet.png");
    }

    private static int darkest(BufferedImage image, int from, int to) {
        int[] colors = image.getRGB(from, 40, to - from, image.getHeight() - 40, null, 0, to - from);
        return Arrays.stream(colors).map(color -> color & 0xff).min().orElseThrow();
    }

    @Test
    void readMeFilesAndOtherJsonAreNoSurfaces() throws IOException {
        Files.writeString(scans.resolve("README.md"), "# 1 2 3");
        Files.writeString(scans.resolve("settings.json"), "{\"note\": \"shed skin\"}");

        assertSuccess(inspect("@scans"));

        assertThat(table("table.csv")).hasSize(1);
        Files.delete(scans.resolve("grating.txt"));
        assertComplaint(ExitCode.UNUSABLE_INPUT, "inspect @scans --output @report --force", "has no scan");
    }

    /** Noise has no period that evaluate could measure. */
    @Test
    void aSurfaceWithoutPeriodHasInspectsVerdictInEvaluatesTable() throws IOException {
        var noise = new SplittableRandom(3);
        String header = "# Channel: Height\n# Width: 16 µm\n# Height: 16 µm\n# Value units: nm\n";
        scan("scans/noise.txt", header, 64, 64, (column, row) -> 20 * noise.nextDouble());
        assertThat(inspect("@scans")).isIn(0, 3);
        List<String> inspected = column("verdict_code");

        assertThat(sunbeam("evaluate @scans --wavelengths 500:600:50 --output @report --force --json"))
                .isEqualTo(4);

        assertThat(column("exit_code")).containsExactly("0", "4");
        assertThat(column("message").get(1)).contains("no period is seen");
        assertThat(column("verdict_code")).isEqualTo(inspected);
        assertThat(inspected.get(1)).isNotEmpty();
        assertThat(out.toString()).doesNotContain("failed");
    }

    @Test
    void partsTogetherAreTheWhole() throws IOException {
        for (String name : List.of("b", "c", "d", "e")) {
            Files.copy(scans.resolve("grating.txt"), scans.resolve(name + ".txt"));
        }
        List<NamedCsvRecord> parts = new ArrayList<>();
        for (String part : List.of("1", "2", "3")) {
            assertSuccess(inspect("@scans --task " + part + "/3"));
            parts.addAll(table("table-" + part + "-of-3.csv"));
        }
        FileTime drawn = time("c.png");

        assertSuccess(inspect("@scans --resume"));

        assertThat(table("table.csv"))
                .extracting(NamedCsvRecord::getFields)
                .containsExactlyElementsOf(
                        parts.stream().map(NamedCsvRecord::getFields).toList());
        assertThat(time("c.png")).as("the joining run draws nothing again").isEqualTo(drawn);
    }

    @Test
    void aStoppedRunGoesOnWhereItWas() throws IOException {
        Files.copy(scans.resolve("grating.txt"), scans.resolve("later.txt"));
        assertThat(inspect("@scans")).isZero();
        // Cut the second line, as if the process had been killed.
        Path reports = report.resolve("reports.jsonl");
        String whole = Files.readString(reports);
        Files.writeString(reports, whole.substring(0, whole.indexOf('\n') + 100));
        Files.delete(report.resolve("table.csv"));
        FileTime first = time("grating.png");
        FileTime second = time("later.png");

        assertSuccess(inspect("@scans --resume"));

        assertThat(Files.readString(reports)).isEqualTo(whole);
        assertThat(time("grating.png")).isEqualTo(first);
        assertThat(time("later.png")).isGreaterThan(second);
        // A changed file is inspected again.
        scan("grating.txt", x -> 0.01);
        assertThat(inspect("@scans --resume")).isEqualTo(3);
        assertThat(table("table.csv").get(0).getField("verdict_code")).isEqualTo("mirror");
    }

    @Test
    void anAngleOfARangeIsARow() throws IOException {
        assertSuccess(inspect("sinusoid --theta-i 0:60:30 --json"));

        assertThat(column("theta_i_deg")).containsExactly("0.0", "30.0", "60.0");
        // A period of 2.5 um under light at 60 degrees has its first orders from asin(0.4 / 2.5 - sin 60) = -44.9
        // degrees.
        String[] angles = table("table.csv").get(2).getField("first_orders_deg").split(" to ", -1);
        assertThat(Double.parseDouble(angles[0])).isCloseTo(-44.9, within(0.1));
        JsonNode summary = new ObjectMapper().readTree(out.toString());
        assertThat(summary.at("/verdict_codes/sure_grating").intValue()).isEqualTo(3);
    }

    @Test
    void colorsOfAFolderHaveTheirPurestColorInTheTable() throws IOException {
        assertSuccess(sunbeam("color @scans blaze --angles -40:40:4 --output @report"));

        assertThat(column("purest_srgb")).allMatch(color -> color.matches("#[0-9a-f]{6}"));
        assertThat(column("theta_i_deg")).containsOnly("0.0");
        assertThat(report.resolve("surfaces").toFile().list())
                .contains("grating.png", "grating.csv", "grating.json", "blaze.png");
    }

    @Test
    void mapsOfAFolderKeepTheOptionsOfTheCommandLine() throws IOException {
        assertSuccess(sunbeam("brdf-map @scans --periodic blaze --explain --size 40 --no-annotate --output @report"));

        assertThat(column("verdict_code")).containsOnly("sure_grating");
        assertThat(ImageIO.read(new File(report.toFile(), "surfaces/blaze.png")).getWidth())
                .isEqualTo(40);
    }

    @Test
    void ordersAndEvaluateTakeAFolderAndAFailureIsARow() throws IOException {
        Files.writeString(scans.resolve("a bad one.gwy"), "no scan");

        assertThat(sunbeam("orders @scans blaze --theta-i 0:30:30 --wavelengths 500 --output @report"))
                .isEqualTo(4);
        assertThat(column("exit_code")).containsExactly("4", "0", "0");
        assertThat(report.resolve("surfaces").toFile().list())
                .contains("grating.png", "grating.csv", "grating.json", "blaze.csv");
        assertThat(Files.readString(report.resolve("surfaces/blaze.json")))
                .as("both angles are in the orders of a surface")
                .contains("\"theta_i_deg\" : 30.0");

        assertThat(sunbeam("evaluate @scans --wavelengths 500:600:50 --output @report --force"))
                .isEqualTo(4);
        assertThat(column("exit_code")).containsExactly("4", "0");
        // The grating of 2 um; the steps of the angles, a hundredth of a degree, are 0.2 % of it at most.
        assertThat(Double.parseDouble(column("peaks_interpolated_mean_m").get(1)))
                .isCloseTo(PERIOD, within(0.002 * PERIOD));
    }

    @Test
    void anEmptyPartIsAnEmptyTable() throws IOException {
        assertSuccess(inspect("@scans --task 1/2"));

        assertThat(Files.readAllLines(report.resolve("table-1-of-2.csv")))
                .singleElement()
                .asString()
                .startsWith("file,exit_code,message,theta_i_deg");
        assertThat(report.resolve("reports-1-of-2.jsonl")).isEmptyFile();
        assertThat(out.toString()).startsWith("0 surfaces");
    }
}
