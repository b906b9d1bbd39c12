package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;

/** {@code --energy conserve} on tracks of a DVD: 740 nm wide, 120 nm deep. */
@NeedsDisplay
class EnergyTest extends CommandLineFixture {
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(65e-6);

    private static final String DISC =
            " @dvd.txt --width 740nm --height 92.5nm --height-unit nm --periodic --force --energy ";
    private static final String LIST = "reflectance --average ensemble --directions @in.csv --output @c.csv" + DISC;

    @BeforeEach
    void writeTracks() throws IOException {
        String row = "0 ".repeat(32) + "120 ".repeat(32);
        Files.write(folder.resolve("dvd.txt"), Collections.nCopies(8, row));
    }

    private void list(String header, List<String> rows) throws IOException {
        Files.writeString(folder.resolve("in.csv"), header + "\n" + String.join("\n", rows) + "\n");
    }

    private double[] column(String name) throws IOException {
        List<String> head =
                List.of(Files.readAllLines(folder.resolve("c.csv")).get(0).split(","));
        return Arrays.stream(rows("c.csv"))
                .mapToDouble(row -> row[head.indexOf(name)])
                .toArray();
    }

    @Test
    void aDiscReflectsNoMoreThanItsShareOfRedLight() throws IOException {
        // The grid covers the three orders at 720 nm; its step is a fraction of their width.
        double width = 720e-9 * WINDOW.sigmaFrequency();
        List<String> rows = new ArrayList<>();
        for (int m = -1; m <= 1; m++) {
            for (int i = -24; i <= 24; i++) {
                for (int j = -12; j <= 12; j++) {
                    double x = m * 720e-9 / 740e-9 + i * width / 6;
                    double y = j * width / 4;
                    double theta = Math.toDegrees(Math.asin(Math.min(0.9999, Math.hypot(x, y))));
                    rows.add("0,0," + theta + "," + Math.toDegrees(Math.atan2(y, x)) + ",720");
                }
            }
        }
        list("theta_i,phi_i,theta_r,phi_r,wavelength", rows);
        // brdf cos theta_r d omega is brdf dx dy.
        double area = width / 6 * width / 4;
        assertSuccess(sunbeam(LIST + "scalar"));
        assertThat(Arrays.stream(column("brdf")).sum() * area).isGreaterThan(1.5 * 0.04);
        assertSuccess(sunbeam(LIST + "conserve"));
        assertThat(Arrays.stream(column("brdf")).sum() * area).isBetween(0.98 * 0.04, 1.01 * 0.04);
    }

    @Test
    void colorsUnderOneLightAreDividedAtEachWavelength() throws IOException {
        Stream<String> rows = IntStream.range(1, 60).mapToObj(i -> "10,0," + (i * 1.4) + "," + (i % 2 == 0 ? 180 : 0));
        list("theta_i,phi_i,theta_r,phi_r", rows.toList());
        assertSuccess(sunbeam(LIST + "scalar"));
        double[] scalar = column("Y");
        assertSuccess(sunbeam(LIST + "conserve --certify 30"));
        double[] conserved = column("Y");
        double least = 1;
        for (int i = 0; i < scalar.length; i++) {
            // Twice the plan's 95th percentile.
            assertThat(conserved[i]).isLessThanOrEqualTo(1.006 * scalar[i]);
            least = scalar[i] > 0 ? Math.min(least, conserved[i] / scalar[i]) : least;
        }
        assertThat(least).isLessThan(0.8);
    }

    private MethodProbe probe() {
        return new MethodProbe(
                folder, "--width 740nm --height 92.5nm --height-unit nm --periodic --patch " + folder + "/dvd.txt");
    }

    @Test
    void aScenesShaderDividesByTheDirectionOfLight() {
        MethodProbe probe = probe();
        MethodPlan plan = probe.plan(VisibleRange.all(), "--average=ensemble");
        EnergyDivisor divisor = new EnergyDivisor(probe.setup().patch().heights(), RefractiveIndex.KERATIN, WINDOW);
        ShaderTables tables = divisor.applyTo(
                probe.setup().tables(plan, MethodUse.COLOR), probe.setup().cie());
        Direction viewer = Direction.ofDegrees(20, 40);
        List<DirectionQuery> queries = IntStream.range(0, 16)
                .mapToObj(i -> Direction.ofDegrees(5 * i, 55.0 * i))
                .map(light -> new DirectionQuery(new DirectionPair(light, viewer), 0))
                .toList();
        List<float[]> results = MethodProbe.evaluate(queries, tables, false);
        double most = 1;
        for (int i = 0; i < queries.size(); i++) {
            DirectionPair pair = queries.get(i).pair();
            double expected = divisor.ofColors(pair.wi(), probe.setup().cie());
            most = Math.max(most, expected);
            // The divisor is interpolated between directions 5 degrees apart, and bends where orders pass the horizon.
            assertThat(Gain.relativeRadiance(pair) / results.get(i)[3])
                    .as("light %s", pair.wi())
                    .isCloseTo(expected, within(0.06 * expected));
        }
        assertThat(most).isGreaterThan(1.2);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            reflectance --method reference               | is not for method reference
            reflectance --preset thesis                  | is not for the thesis's preset
            reflectance --coherence-length 4um           | needs a coherence length of 5um at least
            brdf-map --size 16 --method gem --spacing 1um | is not for method gem
            export --format html                         | give --format bsdf, or npz with --channels spectral
            export --format npz                          | give --format bsdf, or npz with --channels spectral
            export --format npz --channels rec709        | give --format bsdf, or npz with --channels spectral
            reflectance                                  | give
            """)
    void whereNoDivisorIsRightOneLineSaysSo(String command, String words) throws IOException {
        list("theta_i,phi_i,theta_r,phi_r", List.of("0,0,10,0", "1,0,10,0"));
        String files = " --output @o" + (command.startsWith("brdf") ? ".png" : ".csv")
                + (command.startsWith("reflectance") ? " --directions @in.csv" : "");
        assertThat(sunbeam(command + DISC + "conserve" + files)).as("%s", err).isEqualTo(2);
        assertThat(err.toString()).contains("--energy conserve", words);
        assertThat(folder.resolve("o.csv")).doesNotExist();
    }
}
