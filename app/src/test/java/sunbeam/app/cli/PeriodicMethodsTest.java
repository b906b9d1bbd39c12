package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;
import sunbeam.precompute.reference.ExactLight.ReplicaLight;
import sunbeam.precompute.text.Text;

/** Methods for periodic surfaces: nmm and gem, of one wavelength an order, and pq. */
@NeedsDisplay
class PeriodicMethodsTest extends CommandLineFixture {
    // Required by the design: the error of replacing an order's wavelengths by one.
    private static final double MEDIAN_ERROR = 0.01;

    /** Returns sorted errors in the orders; between them there is too little light to compare. */
    private static List<Double> errors(List<float[]> actual, List<float[]> expected) {
        double brightest = expected.stream().mapToDouble(xyz -> xyz[1]).max().orElseThrow();
        return IntStream.range(0, actual.size())
                .filter(i -> expected.get(i)[1] > 1e-6 * brightest)
                .mapToObj(i -> MethodProbe.relativeError(actual.get(i), expected.get(i)))
                .sorted()
                .toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"blaze", "sinusoid", "lamellar"})
    void agreesWithFullAlongAGratingsPlane(String patch) {
        MethodProbe probe = new MethodProbe(folder, "--patch " + patch);
        List<DirectionPair> plane = MethodProbe.gratingPlane(301);
        List<Double> errors = errors(probe.colors(plane, "--method nmm"), probe.colors(plane, "--tolerance 1e-4"));
        assertThat(errors).hasSizeGreaterThan(150);
        assertThat(errors.get(errors.size() / 2)).isLessThan(MEDIAN_ERROR);
    }

    /** The power that evaluate shows for nmm is the power in its colors, not that of method full. */
    @ParameterizedTest
    @CsvSource({"blaze, coherent, 9", "disc, coherent, 20", "disc, ensemble, 20"})
    void itsPowerOverTheWavelengthsIsItsColor(String patch, String average, double degrees) {
        MethodProbe probe = new MethodProbe(folder, "--patch " + patch);
        DirectionPair pair = MethodProbe.inPlane(0, -degrees);
        CieTable cie = probe.setup().cie();

        List<float[]> powers = probe.spectrum(pair, "--method nmm --average " + average);

        float[] color =
                probe.colors(List.of(pair), "--method nmm --average " + average).get(0);
        float[] sum = new float[3];
        for (int i = 0; i < powers.size(); i++) {
            double power = powers.get(i)[average.equals("ensemble") ? 1 : 0];
            for (int c = 0; c < 3; c++) {
                sum[c] += (float) (power * cie.at((380 + i) * 1e-9, c) * 1e-9 / cie.integralOfY());
            }
        }
        // Orders are at least 7 nm wide, so a sum over whole nanometers errs by 1 %.
        assertThat(MethodProbe.relativeError(sum, color)).isLessThan(0.02);
        List<float[]> full = probe.spectrum(pair, "--average " + average);
        assertThat(IntStream.range(0, 401).anyMatch(i -> powers.get(i)[0] != full.get(i)[0]))
                .isTrue();
    }

    @Test
    void theEnsembleOfAMeasuredLikePatchKeepsEachOrderApart() {
        MethodProbe probe = new MethodProbe(folder, "--patch disc");
        List<DirectionPair> directions = IntStream.range(0, 60)
                .mapToObj(
                        i -> new DirectionPair(Direction.ofDegrees(20, 0), Direction.ofDegrees(1.3 * i + 3, 47.0 * i)))
                .toList();
        List<Double> errors = errors(
                probe.colors(directions, "--method nmm --average ensemble"),
                probe.colors(directions, "--average ensemble"));
        assertThat(errors.get(errors.size() / 2)).isLessThan(MEDIAN_ERROR);
    }

    @Test
    void theThesissFormHasAPurpleCast() {
        List<DirectionPair> plane = MethodProbe.gratingPlane(301);
        double full = blueness(blaze.colors(plane, ""));
        double weighted = blueness(blaze.colors(plane, "--method nmm"));
        // Leave out the white mirror order around u = v = 0.
        List<DirectionPair> orders =
                plane.stream().filter(g -> Math.abs(g.u()) > 0.16).toList();
        double thesis = blueness(blaze.colors(orders, "--method nmm --preset thesis"));
        assertThat(weighted / full).isBetween(0.99, 1.01);
        // An order at 450 nm is (450 / 600)^2 = 0.56 times as wide as one at 600 nm; unweighted, it counts as much. On
        // average over an order's colors, at least a tenth more blue.
        assertThat(thesis / full).isGreaterThan(1.1);
    }

    private static double blueness(List<float[]> colors) {
        return colors.stream().mapToDouble(xyz -> xyz[2]).sum()
                / colors.stream().mapToDouble(xyz -> xyz[1]).sum();
    }

    @Test
    void theSpecularDirectionHasItsLimit() {
        List<DirectionPair> specular =
                List.of(MethodProbe.inPlane(0, 0), MethodProbe.inPlane(0, 0.01), MethodProbe.inPlane(0, 0.6));
        List<float[]> full = blaze.colors(specular, "--tolerance 1e-4");
        List<float[]> nmm = blaze.colors(specular, "--method nmm");
        for (int i = 0; i < specular.size(); i++) {
            // 5 nm steps of a smooth spectrum, and the default tolerance of the expansion.
            assertThat(MethodProbe.relativeError(nmm.get(i), full.get(i))).isLessThan(3e-3);
        }
        // The blaze sends most light into its first order; a mirror order would have Y = 1.
        assertThat(nmm.get(0)[1]).isLessThan(0.1f);
    }

    @Test
    void colorsFollowTheGratingEquation() {
        // Spacing 1 um: the first order of 460 nm, 560 nm and 680 nm, and the dark between the orders.
        List<DirectionPair> directions = DoubleStream.of(0.46, 0.58, 0.68, 0.30, 0)
                .mapToObj(sine -> MethodProbe.inPlane(0, Math.toDegrees(Math.asin(sine))))
                .toList();
        List<float[]> xyz = blaze.colors(directions, "--method gem --spacing 1um");
        assertThat(xyz.get(0)[2]).isGreaterThan(2 * xyz.get(0)[0]);
        assertThat(xyz.get(1)[1]).isGreaterThan(xyz.get(1)[0]).isGreaterThan(xyz.get(1)[2]);
        assertThat(xyz.get(2)[0]).isGreaterThan(xyz.get(2)[1]).isGreaterThan(xyz.get(2)[2]);
        assertThat(xyz.get(3)).startsWith(0, 0, 0);
        assertThat(xyz.get(4)[1]).isCloseTo(1, within(1e-5f));
    }

    /** The sum of the bumps in X, Y and Z over all orders with a visible wavelength, across the lines. */
    @Test
    void theThesissFormIsALineOfAllVisibleOrders() {
        double u = 0.75;
        double angle = Math.toDegrees(Math.asin(u));
        List<DirectionPair> directions = List.of(
                MethodProbe.inPlane(0, angle),
                new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(angle, 1)),
                MethodProbe.inPlane(0, 0));
        List<float[]> xyz = blaze.colors(directions, "--method gem --preset thesis");
        double slope = 1.5 * u / (1 + Math.sqrt(1 - u * u));
        double[] white = {0.95047, 1, 1.08883};
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int order = 1; order <= 13; order++) {
                double place = (2500 * u / order - 380) / 400;
                sum += Math.max(0, 1 - Math.pow(4 * place - 3 + c, 2));
            }
            // The display curve of exponent 1 / 2.4 makes exp(-slope^2) out of this factor; computed in float32.
            double expected = 0.1 * white[c] * sum * Math.exp(-2.4 * slope * slope);
            assertThat((double) xyz.get(0)[c]).isCloseTo(expected, within(1e-4 * white[c]));
        }
        assertThat(xyz.get(0)[1]).isGreaterThan(0.01f);
        assertThat(xyz.get(1)).startsWith(0, 0, 0);
        assertThat(xyz.get(2)[1]).isCloseTo(1, within(1e-5f));
    }

    private static final double WAVELENGTH = 500e-9;
    private static final double PERIOD = 2.5e-6;

    private MethodProbe blaze;

    @BeforeEach
    void loadPatch() {
        blaze = new MethodProbe(folder, "--patch blaze");
    }

    private ExactLight exact(int replicas) {
        Replicas square = new Replicas(replicas, replicas);
        return new ReplicaLight(
                blaze.setup().patch().heights(), square, blaze.setup().cie());
    }

    /** Returns light along the normal and the view in the order's direction. */
    private static DirectionPair order(int n) {
        return MethodProbe.inPlane(0, -Math.toDegrees(Math.asin(n * WAVELENGTH / PERIOD)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinc", "linear"})
    void ordersAreExactWithEitherInterpolation(String interpolation) {
        List<DirectionPair> orders = IntStream.rangeClosed(-4, 4)
                .mapToObj(PeriodicMethodsTest::order)
                .toList();
        String options = "--method pq --expansion lowrank --terms 24 --interpolation " + interpolation;
        List<float[]> powers = blaze.powers(orders, WAVELENGTH, options);
        for (int i = 0; i < orders.size(); i++) {
            // Amplitudes of up to 1, in float32: 49 taps of 24 terms round by 7e-7. w T = 2 pi m is hit within float32.
            assertThat(Math.sqrt(powers.get(i)[0]))
                    .isCloseTo(Math.sqrt(exact(26).power(orders.get(i), WAVELENGTH)), within(1e-6));
        }
    }

    @Test
    void sincIsExactBetweenOrders() {
        SplittableRandom random = new SplittableRandom(11);
        List<DirectionPair> directions = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            directions.add(new DirectionPair(
                    Direction.ofDegrees(60 * random.nextDouble(), 360 * random.nextDouble()),
                    Direction.ofDegrees(80 * random.nextDouble(), 360 * random.nextDouble())));
        }
        List<float[]> powers = blaze.powers(directions, WAVELENGTH, "--method pq --replicas 1 --tolerance 1e-5");
        for (int i = 0; i < directions.size(); i++) {
            double expected = exact(1).power(directions.get(i), WAVELENGTH);
            // Amplitudes err by 1e-7 (interpolation), 2e-6 (expansion) and 1e-6 (float32 frequencies of up to 10 bins
            // on slopes of up to 1 a bin), and the power by twice the amplitude times that.
            assertThat((double) powers.get(i)[0]).isCloseTo(expected, within(1e-5 * Math.sqrt(expected) + 1e-9));
        }
    }

    @Test
    void colorAgreesWithTheExactSum() {
        ExactLight light = exact(26);
        List<DirectionPair> directions =
                List.of(MethodProbe.inPlane(0, -12), MethodProbe.inPlane(10, -31), MethodProbe.inPlane(0, 25));
        List<float[]> colors = blaze.colors(directions, "--method pq");
        for (int i = 0; i < directions.size(); i++) {
            double[] xyz = light.xyz(directions.get(i), Quadrature.EXACT);
            // One wavelength per cycle of the power; the expansion has its default tolerance.
            assertThat(MethodProbe.relativeError(
                            colors.get(i), new float[] {(float) xyz[0], (float) xyz[1], (float) xyz[2]}))
                    .isLessThan(5e-3);
        }
    }

    /** The middle pixel is exactly u = v = 0, where both sines of the array factor of method pq vanish. */
    @ParameterizedTest
    @CsvSource({
        "blaze, nmm", "blaze, nmm --average ensemble", "blaze, nmm --preset thesis",
        "disc, nmm", "disc, nmm --average ensemble", "disc, nmm --preset thesis",
        "blaze, pq --interpolation sinc", "blaze, pq --interpolation linear"
    })
    void noPixelOfAMapIsWithoutAColor(String patch, String method) {
        new MethodProbe(folder, "--patch " + patch).assertMapHasColors("--method " + method);
    }

    /** Returns power, rho and BRDF of method pq at 500 nm; angles of light and view in degrees, the view's negative towards -x. */
    private double[][] radiances(String fresnel, double[]... pairs) throws IOException {
        StringBuilder csv = new StringBuilder("theta_i,phi_i,theta_r,phi_r,wavelength\n");
        for (double[] pair : pairs) {
            csv.append(Text.format("%s,0,%s,%s,500%n", pair[0], Math.abs(pair[1]), pair[1] < 0 ? 180 : 0));
        }
        Files.writeString(folder.resolve("in.csv"), csv);
        assertSuccess(sunbeam(
                "reflectance blaze --method pq --directions @in.csv --output @out.csv --force --fresnel " + fresnel));
        return Arrays.stream(rows("out.csv"))
                .map(row -> new double[] {row[5], row[row.length - 2], row[row.length - 1]})
                .toArray(double[][]::new);
    }

    @Test
    void aSpecularFlatPartReflectsAllWithTheEqualAreaBrdf() throws IOException {
        // rho of power 1 at normal incidence is 1; brdf = R0 4 pi sigma^2 / lambda^2 with 4 pi sigma^2 the lit area.
        double[] values = radiances("once", new double[] {0, 0})[0];
        double area = Math.pow(26 * PERIOD, 2);
        double r0 = 0.04;
        // Powers are float32.
        assertThat(values[2] / values[0] * WAVELENGTH * WAVELENGTH / (r0 * area))
                .isCloseTo(1, within(1e-6));
        assertThat(values[1]).isCloseTo(values[0], within(1e-6));
    }

    /** Rho is relative to a mirror's R(0): squared, rho has (R / R(0))^2 and the BRDF R^2 / R(0). */
    @Test
    void theBrdfIsTheSameMultipleOfRhoForBothFormsOfFresnel() throws IOException {
        // At 60 degrees R is 1.75 R(0).
        double[][] pairs = {{0, 0}, {30, 30}, {60, -60}};
        double[][] once = radiances("once", pairs);
        double[][] squared = radiances("squared", pairs);
        for (int i = 0; i < pairs.length; i++) {
            // Text keeps 1e-6 of each value.
            assertThat(squared[i][2] / squared[i][1] / (once[i][2] / once[i][1]))
                    .isCloseTo(1, within(1e-5));
        }
        assertThat(squared[2][1] / once[2][1]).isGreaterThan(1.7);
    }
}
