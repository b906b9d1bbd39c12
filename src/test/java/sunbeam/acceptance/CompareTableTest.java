package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.apache.commons.math3.special.BesselJ;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code compare} of measured tables. */
class CompareTableTest {
    private static final String ANGLES = "theta_i,phi_i,theta_r,phi_r";

    @TempDir
    static Path root;

    private static Workplace workplace;

    @BeforeAll
    static void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    private static JsonNode compare(String... arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of(
                "compare",
                "--json",
                "--output",
                workplace.resolve("compared.png").toString(),
                "--force"));
        all.addAll(List.of(arguments));
        return new ObjectMapper()
                .readTree(workplace.succeedHere(all.toArray(String[]::new)).stdout());
    }

    private static String table(String name, String header, List<String> rows) throws IOException {
        Path file = workplace.resolve(name);
        Files.writeString(file, header + "\n" + String.join("\n", rows) + "\n");
        return file.toString();
    }

    /** BRDF of a sinusoidal relief in the middle of an order (design of the model: J_m squared), 1/sr. */
    private static String orderOfSinusoid(int order, double nanometers) {
        double wavelength = nanometers * 1e-9;
        double x = Math.sin(Math.toRadians(20));
        double seen = -x - order * wavelength / 2.5e-6;
        double w = Math.cos(Math.toRadians(20)) + Math.sqrt(1 - seen * seen);
        double power = Math.pow(BesselJ.value(Math.abs(order), 2 * Math.PI / wavelength * w * 100e-9), 2);
        double cosine = x * seen + (w - Math.sqrt(1 - seen * seen)) * Math.sqrt(1 - seen * seen);
        double mirror = 0.04 + 0.96 * Math.pow(1 - Math.sqrt((1 + cosine) / 2), 5);
        double area = 4 * Math.PI * Math.pow(65e-6 / 4, 2);
        double brdf = mirror
                * Math.pow(1 + cosine, 2)
                * area
                * power
                / (Math.cos(Math.toRadians(20)) * Math.sqrt(1 - seen * seen) * wavelength * wavelength * w * w);
        return String.format(
                Locale.ROOT,
                "20,0,%.9f,%d,%.1f,%.9e",
                Math.toDegrees(Math.asin(Math.abs(seen))),
                seen < 0 ? 180 : 0,
                nanometers,
                3 * brdf);
    }

    @Test
    void theFactorOfAKnownGratingIsFound() throws IOException {
        List<String> rows = new ArrayList<>();
        for (int order = -2; order <= 2; order++) {
            for (int nanometers = 420; nanometers <= 700; nanometers += 70) {
                rows.add(orderOfSinusoid(order, nanometers));
            }
        }
        JsonNode report = compare(table("orders.csv", ANGLES + ",wavelength,brdf", rows), "sinusoid");
        // The plan's tolerance is 1e-3; neighboring orders add less.
        assertThat(report.get("factor").asDouble()).isCloseTo(3, within(3e-3));
        assertThat(report.get("error_p95").asDouble()).isLessThan(3e-3);
        assertThat(report.has("ciede2000_median")).isFalse();
    }

    /** Of colors that the program itself gives, dimmed and with 5 % of noise; and as spectra of which each row is one. */
    @Test
    void noiseMovesTheFactorLittle() throws IOException {
        List<String> directions = new ArrayList<>();
        for (int angle = -60; angle <= 60; angle += 2) {
            directions.add("30,0," + Math.abs(angle) + "," + (angle < 0 ? 180 : 0));
        }
        workplace.succeedHere(
                "reflectance",
                "--patch",
                "blaze",
                "--average",
                "ensemble",
                "--directions",
                table("directions.csv", ANGLES, directions),
                "--output",
                workplace.resolve("xyz.csv").toString());
        CsvFile exact = CsvFile.read(workplace.resolve("xyz.csv"));
        Random random = new Random(1);
        List<String> rows = new ArrayList<>();
        for (int row = 0; row < exact.size(); row++) {
            double scale = 0.37 * exact.at(row, "gain") * (1 + 0.05 * random.nextGaussian());
            rows.add(directions.get(row) + "," + scale * exact.at(row, "X") + "," + scale * exact.at(row, "Y") + ","
                    + scale * exact.at(row, "Z"));
        }
        JsonNode noisy = compare(table("noisy.csv", ANGLES + ",X,Y,Z", rows), "blaze");
        // The median of 61 has a deviation of 5 % x 1.25 / sqrt(61), the weights double it at most; three of them.
        assertThat(noisy.get("factor").asDouble()).isCloseTo(0.37, within(0.37 * 0.05));
        // A change of brightness by 5 % is one of lightness by 1.7 % at most.
        assertThat(noisy.get("ciede2000_p95").asDouble()).isBetween(0.1, 4.0);
        assertThat(CsvFile.read(workplace.resolve("compared.csv")).size()).isEqualTo(61);

        JsonNode given = compare(workplace.resolve("xyz.csv").toString(), "blaze", "--factor", "1");
        assertThat(given.get("factor").asDouble()).isOne();
        assertThat(given.get("error_p95").asDouble()).isLessThan(1e-9);
    }

    /** Columns of wavelengths have a color: a white of the same value everywhere is that of the light. */
    @Test
    void spectraHaveColors() throws IOException {
        StringBuilder header = new StringBuilder(ANGLES);
        StringBuilder row = new StringBuilder("0,0,20,180");
        for (int nanometers = 400; nanometers <= 700; nanometers += 20) {
            header.append(',').append(nanometers);
            row.append(",2.5");
        }
        JsonNode report = compare(table("spectra.csv", header.toString(), List.of(row.toString())), "blaze");
        assertThat(report.get("rows").asInt()).isOne();
        assertThat(report.get("ciede2000_median").asDouble())
                .as("no grating is white")
                .isGreaterThan(5);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''| 0,0,10,0| blaze| beside directions it needs either the columns X,Y,Z",
                "',X,Y,Z,500'| 0,0,10,0,1,1,1,1| blaze| and no two of these",
                "',X,Y,Z'| 0,0,95,0,1,1,1| blaze| 95.0 must lie in 0..89.999 degrees",
                "',X,Y,Z'| 0,0,10,0,1,1e300,1| blaze| is no light",
                "',X,Y,Z'| 0,0,10,0,0,0,0| blaze| dark in all directions",
                "',X,Y,Z'| 0,0,10,0,1,1,1| blaze| one value that is not dark",
                "',wavelength,brdf'| 0,0,10,0,900,1| blaze| must lie in 380..780 nm",
                "',X,Y,Z'| 0,0,10,0,1,1,1| nothing-like-that| is no file that is there",
            })
    void whatIsNoTableIsOneLine(String columns, String row, String patch, String complaint) throws IOException {
        String file = table("wrong.csv", ANGLES + columns, List.of(row));
        String output = workplace.resolve("out.png").toString();
        Complaint.assertThatIt(
                workplace.here("compare", file, patch, "--output", output), Complaint.UNUSABLE_INPUT, complaint);
        assertThat(workplace.resolve("out.png")).doesNotExist();
    }

    @Test
    void optionsOfScenesAreRefused() throws IOException {
        String file = table("right.csv", ANGLES + ",X,Y,Z", List.of("0,0,10,0,1,1,1"));
        Complaint.assertThatIt(
                workplace.here("compare", file, "blaze", "--texture", "none"),
                Complaint.USAGE,
                "--texture none has no place beside a table");
        Complaint.assertThatIt(
                workplace.here("compare", file, "blaze", "--size", "8x8"),
                Complaint.USAGE,
                "--size is for photographs");
        Complaint.assertThatIt(
                workplace.here("compare", file, "blaze", "--force", "--output", file.replace(".csv", ".png")),
                Complaint.USAGE,
                "would write rows over the table");
    }
}
