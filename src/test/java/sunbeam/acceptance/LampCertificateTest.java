package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code brdf-map --angular-diameter --certify}: the mean of the reference over an even disc of light. */
class LampCertificateTest extends InOneWorkplace {
    @ParameterizedTest
    @CsvSource({"3, 0", "5, 3"})
    void aLampErrsAsThePlanSaysButForSharpOrders(double degrees, int code) throws IOException {
        writeSurface(code != 0);
        SunbeamResult result = workplace
                .here("brdf-map heights.txt --width 2um --height 2um --height-unit nm --force --size 24 --theta-i 30"
                        + (code == 0 ? "" : " --periodic --coherence-length 16um")
                        + " --certify 4 --json --output map.png --angular-diameter "
                        + degrees)
                .ended(code);

        // What can be seen: a CIEDE2000 of 1, and twice the tolerance of scenes.
        assertThat(result.stderr()).contains("median error 2.0 %, mean CIEDE2000 1.0 at most");
        JsonNode certificate = new ObjectMapper().readTree(result.stdout()).at("/certificate");
        if (code == 0) {
            assertThat(certificate.at("/median").doubleValue()).isBetween(1e-6, 0.02);
        } else {
            assertThat(certificate.at("/median").doubleValue()).isGreaterThan(0.02);
        }
    }

    private static void writeSurface(boolean isGrating) throws IOException {
        SplittableRandom random = new SplittableRandom(4);
        int side = 32;
        List<String> lines = new ArrayList<>();
        for (int row = 0; row < side; row++) {
            StringBuilder line = new StringBuilder();
            for (int column = 0; column < side; column++) {
                double height = isGrating ? 40 * Math.sin(2 * Math.PI * column / side) : 60 * random.nextDouble();
                line.append(String.format(Locale.ROOT, "%.2f ", height));
            }
            lines.add(line.toString().strip());
        }
        Files.write(workplace.resolve("heights.txt"), lines);
    }
}
