package sunbeam.app.cli.reflectance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;
import sunbeam.precompute.reference.ExactLight.ReplicaLight;

@NeedsDisplay
class PqMethodTest {
    private static final double WAVELENGTH = 500e-9;
    private static final double PERIOD = 2.5e-6;

    @TempDir
    private Path home;

    private MethodProbe blaze;

    @BeforeEach
    void loadPatch() {
        blaze = new MethodProbe(home, "--patch blaze");
    }

    private double exact(DirectionPair pair, int replicas) {
        return new ReplicaLight(
                        blaze.setup().patch().heights(),
                        new Replicas(replicas, replicas),
                        blaze.setup().cie())
                .power(pair, WAVELENGTH);
    }

    /** Returns light along the normal and the view in the order's direction. */
    private static DirectionPair order(int n) {
        return MethodProbe.inPlane(0, -Math.toDegrees(Math.asin(n * WAVELENGTH / PERIOD)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinc", "linear"})
    void ordersAreExactWithEitherInterpolation(String interpolation) {
        List<DirectionPair> orders = new ArrayList<>();
        for (int n = -4; n <= 4; n++) {
            orders.add(order(n));
        }
        String options = "--method pq --expansion lowrank --terms 24 --interpolation " + interpolation;
        List<float[]> powers = blaze.powers(orders, WAVELENGTH, options);
        for (int i = 0; i < orders.size(); i++) {
            // Amplitudes of up to 1, in float32: 49 taps of 24 terms round by 7e-7. w T = 2 pi m is hit within float32.
            assertThat(Math.sqrt(powers.get(i)[0])).isCloseTo(Math.sqrt(exact(orders.get(i), 26)), within(1e-6));
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
            double expected = exact(directions.get(i), 1);
            // Amplitudes err by 1e-7 (interpolation), 2e-6 (expansion) and 1e-6 (float32 frequencies of up to 10 bins
            // on slopes of up to 1 a bin), and the power by twice the amplitude times that.
            assertThat((double) powers.get(i)[0]).isCloseTo(expected, within(1e-5 * Math.sqrt(expected) + 1e-9));
        }
    }

    @Test
    void colorAgreesWithTheExactSum() {
        ExactLight light = new ReplicaLight(
                blaze.setup().patch().heights(),
                new Replicas(26, 26),
                blaze.setup().cie());
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

    @ParameterizedTest
    @ValueSource(strings = {"sinc", "linear"})
    void noPixelOfAMapIsWithoutAColor(String interpolation) {
        // The middle pixel is exactly u = v = 0, where both sines of the array factor vanish.
        blaze.assertMapHasColors("--method pq --interpolation " + interpolation);
    }

    @Test
    void aSpecularFlatPartReflectsAllWithTheEqualAreaBrdf() {
        // rho of power 1 at normal incidence is 1; brdf = R0 4 pi sigma^2 / lambda^2 with 4 pi sigma^2 the lit area.
        float[] values = blaze.powers(List.of(MethodProbe.inPlane(0, 0)), WAVELENGTH, "--method pq")
                .get(0);
        double area = Math.pow(26 * PERIOD, 2);
        double r0 = 0.04;
        assertThat(values[3] / values[0] * WAVELENGTH * WAVELENGTH / (r0 * area))
                .isCloseTo(1.0, within(1e-4));
        assertThat(values[2]).isCloseTo(values[0], within(1e-6f));
    }

    /** Rho is relative to a mirror's R(0): squared, rho has (R / R(0))^2 and the BRDF R^2 / R(0). */
    @Test
    void theBrdfIsTheSameMultipleOfRhoForBothFormsOfFresnel() {
        // At 60 degrees R is 1.75 R(0).
        List<DirectionPair> pairs =
                List.of(MethodProbe.inPlane(0, 0), MethodProbe.inPlane(30, 30), MethodProbe.inPlane(60, -60));
        List<float[]> once = blaze.powers(pairs, WAVELENGTH, "--method pq --fresnel once");
        List<float[]> squared = blaze.powers(pairs, WAVELENGTH, "--method pq --fresnel squared");
        for (int i = 0; i < pairs.size(); i++) {
            double expected = once.get(i)[3] / once.get(i)[2];
            // Rounding of float32.
            assertThat(squared.get(i)[3] / squared.get(i)[2] / expected).isCloseTo(1, within(1e-6));
        }
        assertThat(squared.get(2)[2] / once.get(2)[2]).isGreaterThan(1.7f);
    }
}
