package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** Each source of error alone, in double precision, stays within its share of the budget. */
final class ErrorSourcesTest {
    private static final long HEAP = 4L << 30;
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(5e-6);

    private static final HeightMap WAVES = waves(24, 20, 120e-9);

    private static HeightMap waves(int columns, int rows, double pitch) {
        double x0 = 2 * Math.PI / (columns * pitch);
        double y0 = 2 * Math.PI / (rows * pitch);
        return Surfaces.of(
                columns,
                rows,
                pitch,
                (x, y) -> 62e-9 * (Math.sin(2 * x0 * x + y0 * y) + 0.6 * Math.cos(x0 * x - 3 * y0 * y + 1)));
    }

    static Stream<Named<HeightMap>> surfaces() {
        return Stream.of(
                Named.of("waves", WAVES),
                Named.of("noise", Surfaces.random(24, 20, 120e-9, 400e-9, 3)),
                Named.of("a faint relief", WAVES.map(height -> 0.02 * height)));
    }

    private static Expansion expansion(HeightMap map, double tolerance) {
        return new Planner(HeightLevels.of(map), CieTable.load(), HEAP)
                .plan(
                        TableChoices.within(tolerance),
                        new GaussianArea(WINDOW, WindowOrigin.CENTRE, Average.COHERENT),
                        VisibleRange.all())
                .expansion();
    }

    /** The expansion's terms are summed over the surface directly: no bins, no window's neighborhood, no float32. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void theExpansionKeepsItsShareOfPower(HeightMap map) {
        ReferenceEvaluator evaluator = new ReferenceEvaluator(map, WINDOW, WindowOrigin.CENTRE);
        for (double tolerance : new double[] {1e-2, 1e-4}) {
            Expansion expansion = expansion(map, tolerance);
            SplittableRandom random = new SplittableRandom(4);
            int bright = 0;
            for (int i = 0; i < 40; i++) {
                double wavelength = random.nextDouble(380e-9, 780e-9);
                DirectionPair pair = nearAnOrder(random, map, wavelength);
                double exact = evaluator.coherent(pair, wavelength);
                if (exact >= ErrorBudget.DARKEST_POWER) {
                    bright++;
                    double error = Math.abs(expanded(evaluator, expansion, pair, wavelength) - exact) / exact;
                    // Power errs twice as much as amplitude; the budget is a mean over phases, and a single phase may
                    // have twice as much.
                    double share = 2 * 2 * new ErrorBudget(tolerance).expansion() / Math.sqrt(exact);
                    assertThat(error).as("power %.1e", exact).isLessThan(share + 1e-9);
                }
            }
            assertThat(bright).isGreaterThan(4);
        }
    }

    /** On and around the orders -4..4. */
    private static DirectionPair nearAnOrder(SplittableRandom random, HeightMap map, double wavelength) {
        while (true) {
            Direction light = Direction.ofDegrees(80 * random.nextDouble(), 360 * random.nextDouble());
            double fx = random.nextInt(-4, 5) / map.width() + 4.4 * WINDOW.sigmaFrequency() * random.nextDouble(-1, 1);
            double fy = random.nextInt(-4, 5) / map.height() + 1.5 * WINDOW.sigmaFrequency() * random.nextDouble(-1, 1);
            double x = -light.x() - wavelength * fx;
            double y = -light.y() - wavelength * fy;
            if (x * x + y * y < 0.98) {
                return new DirectionPair(light, Direction.ofDisc(x, y));
            }
        }
    }

    private static double expanded(
            ReferenceEvaluator evaluator, Expansion expansion, DirectionPair pair, double wavelength) {
        double[] coefficients = expansion.coefficients(expansion.scale().phase(wavelength, Math.abs(pair.w())));
        double[] scaled = Arrays.stream(evaluator.heights().levels())
                .map(expansion.scale()::scaled)
                .toArray();
        Complex sum = Complex.ZERO;
        for (int n = 0; n < expansion.terms(); n++) {
            int term = n;
            double[] real = Arrays.stream(scaled)
                    .map(s -> expansion.basis(term, s).getReal())
                    .toArray();
            double[] imaginary = Arrays.stream(scaled)
                    .map(s -> expansion.basis(term, s).getImaginary())
                    .toArray();
            Complex seen = evaluator.windowed(real, imaginary, pair.u() / wavelength, pair.v() / wavelength);
            sum = sum.add(seen.multiply(expansion.kind().turn(n)).multiply(coefficients[n]));
        }
        return sum.abs() * sum.abs();
    }

    /** A lone bright bin half a bin beyond the neighborhood contributes less than the budget; a smaller neighborhood would not do. */
    @ParameterizedTest
    @ValueSource(doubles = {0.15, 0.4, 1, 2.3, 9})
    void theNeighborhoodIsAsLargeAsItMustBe(double sigmaBins) {
        for (double tolerance : new double[] {1e-2, 1e-3, 1e-4}) {
            ErrorBudget budget = new ErrorBudget(tolerance);
            int radius = budget.neighborhoodRadius(sigmaBins);
            assertThat(gauss((radius + 0.5) / sigmaBins)).isLessThanOrEqualTo(budget.leftOut());
            if (radius > 0) {
                assertThat(gauss((radius - 0.5) / sigmaBins)).isGreaterThan(budget.leftOut());
            }
        }
    }

    private static double gauss(double deviations) {
        return Math.exp(-0.5 * deviations * deviations);
    }
}
