package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Expansion.TaylorExpansion;

class ExpansionTest {
    private static final int SIDE = 32;
    private static final double SHORTEST_WAVELENGTH = 380e-9;

    /** A wave, and reliefs with nearly all heights in narrow clusters, such as terraces or a polished surface with dust. */
    static Stream<Arguments> surfaces() {
        return Stream.of(
                Arguments.of("wave", Surfaces.of(SIDE, SIDE, 50e-9, (x, y) -> 400e-9 * Math.sin(4e6 * x + 1e6 * y))),
                Arguments.of("5 nm of roughness and a grain", surface(5e-9, 20e-6)),
                Arguments.of("5 nm of roughness and four grains", surface(5e-9, 20e-6, 12e-6, -6e-6, 9e-6)),
                Arguments.of("a tenth of a nanometre and a grain", surface(1e-10, 20e-6)),
                Arguments.of("120 nm of roughness and a grain", surface(120e-9, 15e-6)),
                Arguments.of(
                        "rough terraces",
                        Surfaces.of(SIDE, SIDE, 200e-9, (x, y) -> 20e-6 * Math.floor(x / 1.7e-6) + 1e-9 * x / 1e-6)));
    }

    private static HeightMap surface(double roughness, double... grains) {
        Random random = new Random(1);
        double[] heights = random.doubles(SIDE * SIDE)
                .map(unused -> roughness * random.nextGaussian())
                .toArray();
        for (int i = 0; i < grains.length; i++) {
            heights[137 * (i + 1)] = grains[i];
        }
        return Surfaces.sampled(SIDE, SIDE, 100e-9, (column, row) -> heights[row * SIDE + column]);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("surfaces")
    void theStatedErrorIsThatOfTheHeightsThemselves(String name, HeightMap map) {
        HeightMap heights = map;
        HeightScale scale = HeightScale.midRange(heights);
        double maximum = scale.phase(SHORTEST_WAVELENGTH, 2);
        for (double tolerance : new double[] {1e-3, 1e-6}) {
            LowRankExpansion expansion = LowRankExpansion.of(heights, scale, 0, maximum, tolerance, Integer.MAX_VALUE);
            double square = meanSquaredError(expansion, map, maximum);
            assertThat(expansion.error()).isLessThanOrEqualTo(tolerance);
            // Both sum some thousand squares of differences of numbers near 1.
            assertThat(Math.sqrt(square)).isCloseTo(expansion.error(), within(1e-4 * tolerance + 1e-11));
        }
    }

    /** Over all heights and all phases, the latter by a rule that is exact for squares. */
    private static double meanSquaredError(Expansion expansion, HeightMap map, double maximum) {
        PhaseNodes nodes = PhaseNodes.of(0, maximum, 2);
        double[][] coefficients = new double[nodes.count()][];
        Arrays.setAll(coefficients, q -> expansion.coefficients(nodes.phases()[q]));
        return Arrays.stream(map.heights())
                .map(expansion.scale()::scaled)
                .parallel()
                .map(s -> {
                    Complex[] basis = new Complex[expansion.terms()];
                    Arrays.setAll(basis, n -> new Complex(expansion.realBasis(n, s), expansion.imaginaryBasis(n, s)));
                    double sum = 0;
                    for (int q = 0; q < nodes.count(); q++) {
                        sum += nodes.weights()[q] * squaredError(nodes.phases()[q] * s, basis, coefficients[q]);
                    }
                    return sum;
                })
                .average()
                .orElseThrow();
    }

    private static double squaredError(double phase, Complex[] basis, double[] coefficients) {
        Complex rest = new Complex(Math.cos(phase), -Math.sin(phase));
        for (int n = 0; n < basis.length; n++) {
            rest = rest.subtract(basis[n].multiply(coefficients[n]));
        }
        return rest.multiply(rest.conjugate()).getReal();
    }

    @Test
    void parabolasThroughThreeSamplesErrByLessThanFloat32RoundsThePhase() {
        HeightMap heights = Surfaces.of(SIDE, SIDE, 2e-6, (x, y) -> 20e-6 * Math.floor(x / 16.5e-6));
        HeightScale scale = HeightScale.midRange(heights);
        Expansion expansion =
                LowRankExpansion.of(heights, scale, 0, scale.phase(SHORTEST_WAVELENGTH, 2), 1e-6, Integer.MAX_VALUE);
        CoefficientTable table = CoefficientTable.sampled(expansion);
        // Coefficients of these two levels are at most 2.
        double rounding = 2 * 0.5 * Math.ulp((float) expansion.maximumPhase());
        double perSample = expansion.maximumPhase() / (table.samples() - 1);

        for (double zeta = 0.3; zeta < expansion.maximumPhase() - 1; zeta += 3.7) {
            double[] exact = expansion.coefficients(zeta);
            int middle = (int) Math.round(zeta / perSample);
            double t = zeta / perSample - middle;
            for (int n = 0; n < table.terms(); n++) {
                float[] values = table.floats(n);
                double parabola = t * (t - 1) / 2 * values[middle - 1]
                        + (1 - t * t) * values[middle]
                        + t * (t + 1) / 2 * values[middle + 1];
                assertThat(parabola).isCloseTo(exact[n], within(rounding));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"4.712388980384690, 20", "2, 12", "6.2, 25"})
    void taylorErrsByLagrangesBoundWithoutAnExponential(double zeta, int terms) {
        // Thesis eq. 2.51, first at x = 1.5 pi and N = 20: 2.7e-6 with M = 1 in place of e^x, which is 111.
        TaylorExpansion taylor = new TaylorExpansion(new HeightScale(0, 1e-6), terms, zeta);
        double[] coefficients = taylor.coefficients(zeta);
        double worst = 0;
        for (double s = -1; s <= 1; s += 0.01) {
            double at = s;
            Complex[] basis = new Complex[terms];
            Arrays.setAll(basis, n -> taylor.kind().turn(n).multiply(taylor.realBasis(n, at)));
            worst = Math.max(worst, Math.sqrt(squaredError(zeta * s, basis, coefficients)));
        }
        // The bound is tight within the next term's factor.
        assertThat(worst).isBetween(taylor.error() / 10, taylor.error());
    }

    @Test
    void skirtsAreInterpolatedAsWellAsPeaks() {
        double skirt = 4.6;
        InterpolationDesign design = InterpolationDesign.within(1e-4, skirt);
        InterpolationDesign.Spread spread = design.spread();
        for (double distance = 0; distance <= skirt; distance += 0.37) {
            double f = 0.3 + distance * design.deviation();
            double sum = 0;
            for (int m = (int) Math.ceil(f - 0.5 * design.taps()); m <= f + 0.5 * design.taps(); m++) {
                sum += design.kernel(f - m) * spread.value(m - 0.3);
            }
            double gauss = Math.exp(-0.5 * distance * distance);
            // The requested error, with a margin for places between those of the design. A design relative to the peak
            // errs by 2 % at four deviations.
            assertThat(Math.abs(sum / gauss - 1)).as("%s deviations", distance).isLessThan(2e-4);
        }
    }
}
