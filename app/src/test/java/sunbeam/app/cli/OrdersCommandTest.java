package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.apache.commons.math3.special.BesselJ;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.terminal.ExitCode;

class OrdersCommandTest extends CommandLineFixture {
    private int run(String options) {
        return sunbeam("orders --force --output @o " + options);
    }

    private static JsonNode order(JsonNode incidence, int m) {
        return incidence
                .get("orders")
                .valueStream()
                .filter(order -> order.get("m").asInt() == m)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void writesDirectionAndEfficiencyOfEachOrder() throws IOException {
        assertSuccess(run("sinusoid --theta-i 0:40:20 --wavelengths 400:700:10"));

        JsonNode incidence = readJson("o.json").get("incidences").get(1);
        assertThat(incidence.get("theta_i_deg").asDouble()).isEqualTo(20);
        JsonNode first = order(incidence, -1);
        // 550 nm; sin theta_r = -sin theta_i - lambda / d, towards azimuth 180.
        double sine = Math.sin(Math.toRadians(20)) + 550.0 / 2500;
        assertThat(first.get("theta_r_deg").get(15).asDouble())
                .isCloseTo(Math.toDegrees(Math.asin(sine)), within(1e-9));
        assertThat(first.get("phi_r_deg").get(15).asDouble()).isCloseTo(180, within(1e-9));
        double cosR = Math.sqrt(1 - sine * sine);
        double cosI = Math.cos(Math.toRadians(20));
        double dot = cosR * cosI - Math.sin(Math.toRadians(20)) * sine;
        double reflectance = 0.04 + 0.96 * Math.pow(1 - Math.sqrt((1 + dot) / 2), 5);
        double expected = reflectance
                * Math.pow((1 + dot) / (cosR + cosI), 2)
                / (cosR * cosI)
                * Math.pow(BesselJ.value(1, 2 * Math.PI / 550e-9 * (cosR + cosI) * 100e-9), 2);
        // The expansion errs by 1e-6; 128 samples per period are exact for a sinusoid.
        assertThat(first.get("efficiency").get(15).asDouble()).isCloseTo(expected, within(1e-6));
        // Order -3 leaves the hemisphere at 2500 nm (1 - sin 20) / 3 = 548.3 nm.
        assertThat(order(incidence, -3).get("beyond_horizon_from_m").asDouble()).isCloseTo(550e-9, within(1e-15));
        assertThat(order(incidence, -3).get("efficiency")).hasSize(15);
        assertThat(ImageIO.read(folder.resolve("o.png").toFile()).getHeight()).isGreaterThan(1500);
    }

    @Test
    void theTableIsAListOfDirectionsAndAddsUp() throws IOException {
        assertSuccess(run("lamellar --theta-i 30 --phi-i 90 --wavelengths 500 --index 0.97+6.5i"));

        assertThat(out.toString()).contains("under light at 30 degrees, turned by 90 degrees");
        assertThat(folder.resolve("o.csv"))
                .content()
                .startsWith("theta_i,phi_i,theta_r,phi_r,wavelength,m,n,efficiency,low,high,sum,mirror\n");
        double[][] rows = rows("o.csv");
        for (double[] row : rows) {
            // Conical incidence: orders keep the light's component along the lines.
            double theta = Math.toRadians(row[2]);
            double phi = Math.toRadians(row[3]);
            assertThat(Math.sin(theta) * Math.sin(phi)).isCloseTo(-0.5, within(1e-9));
            assertThat(Math.sin(theta) * Math.cos(phi)).isCloseTo(row[5] * 500 / 2500, within(1e-9));
        }
        double sum = Arrays.stream(rows).mapToDouble(row -> row[7]).sum();
        assertThat(rows[0][10]).isCloseTo(sum, within(1e-12));
        // |n - 1|^2 / |n + 1|^2 of chromium-like n = 0.97 + 6.5i, seen at 30 degrees.
        assertThat(rows[0][11]).isBetween(0.91, 0.92);
    }

    @Test
    void anOrdersColorIsThatOfItsLight() throws IOException {
        assertSuccess(run("sinusoid --wavelengths 620:640:5"));
        String color = order(readJson("o.json").get("incidences").get(0), 1)
                .get("srgb")
                .asText();
        int rgb = Integer.parseInt(color.substring(1), 16);
        assertThat(rgb >> 16).as(color).isGreaterThan(3 * (rgb & 0xFF)).isGreaterThan(3 * (rgb >> 8 & 0xFF));
    }

    @Test
    void aScanHasTheLightAroundEachOrderWithItsInterval() throws IOException {
        assertThat(run("elaphe-like --no-periodic --wavelengths 550 --crop 0um:20um,0um:20um"))
                .as(err.toString())
                .isIn(0, ExitCode.TOLERANCE_MISSED.code());
        JsonNode incidence = readJson("o.json").get("incidences").get(0);
        for (JsonNode order : incidence.get("orders")) {
            double value = order.get("efficiency").get(0).asDouble();
            assertThat(order.get("efficiency_low").get(0).asDouble()).isLessThan(value);
            assertThat(order.get("efficiency_high").get(0).asDouble()).isGreaterThan(value);
        }
        assertThat(incidence.get("between_orders").get(0).asDouble()).isPositive();
    }

    @Test
    void warningsNameTheCommandThatTellsMore() throws IOException {
        scan("steep.txt", "", 64, 64, (column, row) -> 900 * Math.sin(2 * Math.PI * column / 16));
        run("@steep.txt --width 20um --height-unit nm --wavelengths 550");
        assertThat(err.toString()).contains("(inspect --explain tells more)");
    }

    @Test
    void theNameOfTheFilesHasNoEnding() {
        assertSuccess(sunbeam("orders blaze --wavelengths 500 --output @a.csv"));
        assertThat(folder.resolve("a.csv")).exists();
        assertThat(folder.resolve("a.png")).exists();
        assertThat(folder.resolve("a.csv.csv")).doesNotExist();
        assertComplaint(ExitCode.USAGE, "orders blaze --wavelengths 500 --output ", "--output '' names no file");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            bumps                                    | 4 | bumps: no orders without a period
            blaze --theta-i 90                       | 2 | --theta-i 90:90:1 leaves the range 0 to 89.9
            blaze --wavelengths 300:500:10           | 2 | --wavelengths 300:500:10 leaves the range 380 to 780
            blaze --theta-i 0:80:0.001 --wavelengths 380:780:0.001 | 2 | are too many for this patch
            elaphe-like                              | 2 | for this patch of 91920 orders; take larger steps, or --no-periodic
            @wide.txt --columns=512 --width=5mm --height-unit=nm --periodic | 2 | too many for this patch of 1062314 orders
            """)
    void mistakesAreOneLine(String arguments, int code, String start) throws IOException {
        Files.writeString(folder.resolve("wide.txt"), "0 ".repeat(256) + "50 ".repeat(256));
        assertThat(run(arguments)).as("%s", err).isEqualTo(code);
        assertThat(err.toString().lines().filter(line -> !line.startsWith("warning")))
                .anyMatch(line -> line.contains(start));
        assertThat(folder.resolve("o.csv")).doesNotExist();
    }
}
