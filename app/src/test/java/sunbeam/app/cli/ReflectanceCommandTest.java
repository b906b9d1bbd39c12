package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import sunbeam.app.cli.ReflectanceCommand.Evaluator;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;

/** Turned patches, which equal light and viewer turned the other way; other materials; method table and other illuminants. */
@NeedsDisplay
class ReflectanceCommandTest extends CommandLineFixture {
    private static final int SIDE = 24;

    private void run(String line) {
        assertSuccess(sunbeam(line + " --coherence-length 10um --force"));
    }

    /** Returns X, Y, Z and gain of pairs of directions, each theta_i, phi_i, theta_r, phi_r in degrees. */
    private double[][] reflectance(double[][] pairs, String more) throws IOException {
        StringBuilder csv = new StringBuilder("theta_i,phi_i,theta_r,phi_r\n");
        for (double[] pair : pairs) {
            csv.append(Text.format("%.12f,%.12f,%.12f,%.12f%n", pair[0], pair[1], pair[2], pair[3]));
        }
        Files.writeString(folder.resolve("in.csv"), csv);
        run("reflectance blaze --directions @in.csv --output @out.csv " + more);
        return Arrays.stream(rows("out.csv"))
                .map(row -> Arrays.copyOfRange(row, 4, row.length))
                .toArray(double[][]::new);
    }

    @Test
    void listsSeeBothAzimuthsTurnedTheOtherWay() throws IOException {
        double[][] pairs = {{20, 30, 5, 35}, {20, 30, 5, -140}, {40, 200, 60, 10}, {0, 0, 12, 210}};
        double[][] back = Arrays.stream(pairs)
                .map(pair -> new double[] {pair[0], pair[1] - 37, pair[2], pair[3] - 37})
                .toArray(double[][]::new);

        double[][] turned = reflectance(pairs, "--rotate-patch 37");
        double[][] expected = reflectance(back, "--rotate-patch 0");

        for (int i = 0; i < pairs.length; i++) {
            // The angles are equal but for the 1e-12 that the list's text keeps.
            assertThat(turned[i]).containsExactly(expected[i], within(1e-6 * expected[i][3] + 1e-6 * expected[i][1]));
        }
        assertThat(expected[3][1]).as("light on an order").isGreaterThan(0);
    }

    @Test
    void mapsAgreeWithListsAndKeepTheirCertificate() throws IOException {
        run("brdf-map blaze --average coherent --output @map.png --linear @map.npy --size " + SIDE
                + " --theta-i 25 --phi-i 70 --rotate-patch -50 --certify 3");
        float[] map = floats("map.npy", 3 * SIDE * SIDE);
        int[] pixels = {7 * SIDE + 9, 12 * SIDE + 5, 15 * SIDE + 18, 16 * SIDE + 12};
        double[][] pairs = Arrays.stream(pixels)
                .mapToObj(pixel -> {
                    double x = (2.0 * (pixel % SIDE) + 1) / SIDE - 1;
                    int row = pixel / SIDE;
                    double y = 1 - (2.0 * row + 1) / SIDE;
                    double theta = Math.toDegrees(Math.asin(Math.hypot(x, y)));
                    return new double[] {25, 70 + 50, theta, Math.toDegrees(Math.atan2(y, x)) + 50};
                })
                .toArray(double[][]::new);

        double[][] listed = reflectance(pairs, "--average coherent");

        double brightest =
                Arrays.stream(listed).mapToDouble(row -> row[1]).max().orElseThrow();
        assertThat(brightest).isGreaterThan(1e-6);
        for (int i = 0; i < pixels.length; i++) {
            for (int c = 0; c < 3; c++) {
                double rho = listed[i][3] * listed[i][c];
                // The map and the list have different plans with a tolerance of 1e-3 each; 95 % keep three times that.
                assertThat((double) map[3 * pixels[i] + c]).isCloseTo(rho, within(6e-3 * (rho + 1e-3 * brightest)));
            }
        }
    }

    @Test
    void aSurfacesColorTurnsWithIt() throws IOException {
        List<JsonNode> told = new ArrayList<>();
        for (String turn : List.of("0", "30")) {
            run("color blaze --output @c.png --rotate-patch " + turn);
            told.add(readJson("c.json").at("/surfaces/0"));
        }
        JsonNode turned = told.get(1);

        assertThat(turned.get("plane_azimuth_deg").asDouble())
                .isCloseTo(told.get(0).get("plane_azimuth_deg").asDouble() + 30, within(1e-9));
        assertThat(turned.get("verdict").asText()).contains("across 30 degrees");
        for (int i = 0; i < turned.get("colors").size(); i++) {
            double before = told.get(0).get("colors").get(i).get("Y").asDouble();
            // The same pairs of directions, rounded to float32 on an order's flank.
            assertThat(turned.get("colors").get(i).get("Y").asDouble()).isCloseTo(before, within(1e-3 * before + 1e-9));
        }
    }

    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(10e-6);
    // Rounding of a few products.
    private static final double ROUNDING = 1e-12;

    /** Returns the last row's values of an index at a power or Y of 1. */
    private double[] indexed(RefractiveIndex index, FresnelFactor fresnel, String rows) throws IOException {
        boolean isColor = rows.split(",", -1).length == 4;
        String text = "theta_i,phi_i,theta_r,phi_r" + (isColor ? "\n" : ",wavelength\n") + rows + "\n";
        DirectionList list = DirectionList.read(Files.writeString(folder.resolve("list.csv"), text));
        int count = list.rows().size();
        Gain gain = ReflectionPart.gain(index, CieTable.load(), fresnel.exponent());
        return new Evaluator(list, new Environment(Map.of(), folder).progress())
                .radiances(gain, WINDOW, true, Collections.nCopies(count, new double[] {1, 1, 1}))
                .get(count - 1);
    }

    @Test
    void alongTheNormalTheBrdfHasTheMaterialsReflectanceAndRhoIsOne() throws IOException {
        RefractiveIndex silver = RefractiveIndex.parse("0.05+3.3i");
        double[] silvered = indexed(silver, FresnelFactor.ONCE, "0,0,0,0,550");

        double r0 = (0.95 * 0.95 + 3.3 * 3.3) / (1.05 * 1.05 + 3.3 * 3.3);
        assertThat(silvered[0]).isEqualTo(1);
        assertThat(silvered[2]).isCloseTo(1, within(ROUNDING));
        // 4 pi (sigma / (2 lambda))^2 (1 + wi.wr)^2 at w = -2.
        double area = Math.PI * Math.pow(2 * WINDOW.sigmaMeters() / 550e-9, 2);
        assertThat(silvered[3]).isCloseTo(r0 * area, within(ROUNDING * area));
    }

    /** All materials reflect all grazing light, so rho is inversely proportional to the mirror's reflectance. */
    @Test
    void grazingLightIsReflectedByAllAlike() throws IOException {
        double[] gain = indexed(RefractiveIndex.parse("3"), FresnelFactor.ONCE, "89.9,0,89.9,180");
        double[] keratin = indexed(RefractiveIndex.KERATIN, FresnelFactor.ONCE, "89.9,0,89.9,180");
        // 0.04 over 0.25; the limit is for 90 degrees, at 89.9 degrees 0.9 % is not reflected.
        assertThat(gain[3] / keratin[3]).isCloseTo(0.16, within(0.02 * 0.16));
    }

    @Test
    void anIndexByWavelengthIsTakenAtTheRowsWavelength() throws IOException {
        RefractiveIndex index = new RefractiveIndex(new TreeMap<>(Map.of(380e-9, 1.5, 780e-9, 3.5)), new TreeMap<>());
        double violet = indexed(index, FresnelFactor.ONCE, "0,0,0,0,380")[2];
        // n = 2.5: (1.5 / 3.5)^2 over 0.04.
        assertThat(indexed(index, FresnelFactor.ONCE, "0,0,0,0,380\n0,0,0,0,580")[2] / violet)
                .isCloseTo(1.5 * 1.5 / 3.5 / 3.5 / 0.04, within(1e-9));
    }

    /** Rho has (R / R(0))^2, the BRDF R(0) times as much. */
    @Test
    void theSquareOfAMaterialsReflectanceIsThatOfRho() throws IOException {
        RefractiveIndex index = RefractiveIndex.parse("3");
        double[] once = indexed(index, FresnelFactor.ONCE, "60,0,60,180,550");
        double[] row = indexed(index, FresnelFactor.SQUARED, "60,0,60,180,550");

        double relative = index.reflectance(550e-9, 0.5) / 0.25;
        assertThat(row[2] / once[2]).isCloseTo(relative, within(ROUNDING));
        assertThat(row[3] / once[3]).isCloseTo(relative, within(ROUNDING));
    }

    // A short window makes small tables.
    private static final String TABLE = "--coherence-length 6um --method table";

    private static double[] xyz(float[] color) {
        return new double[] {color[0], color[1], color[2]};
    }

    @Test
    void nothingRingsBesideTheSpecularPeak() {
        // Between the mirror order and the next one there is only its tail, down to 1e-9.
        MethodProbe probe = new MethodProbe(folder, "--patch blaze");
        List<DirectionPair> skirt = IntStream.range(0, 30)
                .mapToDouble(i -> 0.002 * i)
                .mapToObj(sine -> new DirectionPair(new Direction(0, 0, 1), Direction.ofDisc(0.3 * sine, sine)))
                .toList();
        List<float[]> exact = probe.colors(skirt, "--tolerance 1e-4");
        List<float[]> table = probe.colors(skirt, "--method table --tolerance 1e-3");
        int[] lit = IntStream.range(0, skirt.size())
                .filter(i -> exact.get(i)[1] > 1e-8)
                .toArray();
        assertThat(IntStream.of(lit).mapToDouble(i -> exact.get(i)[1]).min().orElseThrow())
                .as("the wing's end")
                .isLessThan(1e-6);
        ErrorStatistics errors = ErrorStatistics.of(IntStream.of(lit)
                .mapToDouble(i -> new Comparison(xyz(table.get(i)), xyz(exact.get(i)), 1).relative())
                .toArray());
        assertThat(errors.keep(1e-3)).as("%s", errors).isTrue();
    }

    @Test
    void lightFromTheHorizonGivesNumbersEverywhere() {
        List<DirectionPair> grazing = IntStream.rangeClosed(0, 20)
                .mapToObj(i -> MethodProbe.inPlane(90, -4.5 * i))
                .toList();
        assertThat(probe().colors(grazing, TABLE + " --tolerance 1e-2"))
                .allMatch(xyz -> Float.isFinite(xyz[1]) && xyz[1] >= 0);
    }

    @Test
    void aTableThatHasNoRoomIsRefusedBeforeAnythingIsTakenForIt() {
        VisibleRange map = VisibleRange.of(new Direction(0, 0, 1));
        assertRefused(map, "10mm", "(?s).* layers, more than .*coarser --tolerance.*");
        assertRefused(map, "600um", "(?s).*need a texture of [0-9.]+ GB, more than .*");
        assertRefused(VisibleRange.all(), "10mm", "(?s).*texels along a side.*");
    }

    private void assertRefused(VisibleRange range, String coherenceLength, String message) {
        MethodProbe probe = new MethodProbe(folder, "--patch blaze");
        assertThatThrownBy(() -> probe.plan(range, "--method table --coherence-length " + coherenceLength))
                .isInstanceOf(SettingException.class)
                .hasMessageMatching(message);
    }

    private MethodProbe probe() {
        return new MethodProbe(folder, "--patch sinusoid");
    }

    /** Medians keep the tolerance of 1e-3. */
    @ParameterizedTest
    @CsvSource({
        "full, --illuminant=F11, ensemble",
        "full, --wavelengths=632.8nm, coherent",
        "full, --wavelengths=500nm..560nm, ensemble",
        "full, --illuminant=A, ensemble",
        "table, --illuminant=F11, ensemble",
        "table, --wavelengths=532nm, ensemble"
    })
    void colorsAreThoseOfTheReference(String method, String light, String average) {
        MethodProbe probe = probe();
        String options = "--method=" + method + " " + light + " --average=" + average + " --coherence-length=20um";
        Choices choices = CommandLine.populateCommand(new MethodOptions(), MethodProbe.words(options))
                .choices();
        ExactLight exact = probe.setup().withLight(LightTable.of(choices)).exact(Methods.of(choices));
        List<DirectionPair> pairs = MethodProbe.gratingPlane(13);

        List<float[]> colors = probe.colors(pairs, options);

        double brightest = colors.stream().mapToDouble(color -> color[1]).max().orElseThrow();
        for (int i = 0; i < colors.size(); i++) {
            double[] expected = exact.xyz(pairs.get(i), ExactLight.Quadrature.INTEGRATED);
            float[] rounded = {(float) expected[0], (float) expected[1], (float) expected[2]};
            double error = MethodProbe.relativeError(colors.get(i), rounded);
            // Three times the tolerance, relative to at least a thousandth of the brightest color.
            assertThat(error).isLessThanOrEqualTo(3e-3 * Math.max(1, 1e-3 * brightest / expected[1]));
        }
    }

    private static DirectionPair at(double sine) {
        return MethodProbe.inPlane(0, Math.toDegrees(Math.asin(sine)));
    }

    @ParameterizedTest
    @CsvSource({"nmm", "gem"})
    void whatSeesOneWavelengthAnOrderRefusesLines(String method) {
        assertThatThrownBy(() -> probe().colors(List.of(at(0.2)), "--method=" + method + " --illuminant=F11"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("has lines");
    }
}
