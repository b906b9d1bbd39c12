package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.setting.Sentence;

/** Windows with few samples: what the plan says of them is what is measured. */
@NeedsDisplay
class CoarseWindowTest extends InAContext {
    private static final double TOLERANCE = 1e-4;
    private static final double PITCH = 350e-9;

    private static FullMethod method(double coherenceLength, Average average) {
        return new FullMethod(
                TableChoices.within(TOLERANCE),
                new GaussianArea(CoherenceWindow.ofCoherenceLength(coherenceLength), WindowOrigin.CENTRE, average));
    }

    private static List<Sentence> shortfalls(HeightMap map, FullMethod method, List<Query> queries) {
        Comparison comparison = new Comparison(context, map, method);
        return new Planner(map, HeightLevels.of(map), CieTable.load()).shortfalls(comparison.plan(queries));
    }

    private static double stated(List<Sentence> shortfalls) {
        assertThat(shortfalls).hasSize(1);
        return Double.parseDouble(
                shortfalls.get(0).parts().get(0).toString().replaceAll(".*are ([0-9.e+-]+) too large.*", "$1"));
    }

    /** 2.8 samples a coherence length, and one row that is longer than the window is wide. */
    @ParameterizedTest
    @CsvSource({"24, 20, 350e-9, 0.99e-6", "40, 1, 5e-6, 4e-6"})
    void aCoherentPowerIsTooLargeByTheNumberThatIsStated(int columns, int rows, double pitchY, double length) {
        HeightMap square = Surface.noise(columns, rows, rows == 1 ? 100e-9 : PITCH, 300e-9, 3);
        HeightMap map = new HeightMap(columns, rows, square.pitchX(), pitchY, square.toArray());
        FullMethod method = method(length, Average.COHERENT);
        List<Query> queries = new Directions(4).nearOrders(map, method.area().window(), 30);
        double stated = stated(shortfalls(map, method, queries));
        assertThat(stated).isGreaterThan(TOLERANCE);
        // Two digits are told.
        assertThat(new Comparison(context, map, method).powerErrors(queries).median())
                .isCloseTo(stated, within(0.1 * stated));
    }

    /** Ensemble powers are those of the reference, whose definition holds for any window. */
    @Test
    void anEnsembleKeepsTheToleranceWithFewSamplesToo() {
        HeightMap map = Surface.noise(24, 20, PITCH, 300e-9, 3);
        FullMethod method = method(0.99e-6, Average.ENSEMBLE);
        List<Query> queries = new Directions(4).queries(60);
        assertThat(shortfalls(map, method, queries)).isEmpty();
        new Comparison(context, map, method).powerErrors(queries).assertWithin(TOLERANCE, "ensemble");
    }
}
