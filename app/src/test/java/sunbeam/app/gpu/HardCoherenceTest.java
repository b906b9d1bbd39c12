package sunbeam.app.gpu;

import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;

/** Windows from a third of the patch to three hundred times it: whatever way the plan takes, it keeps the tolerance. */
@NeedsDisplay
class HardCoherenceTest extends InAContext {
    private static final HeightMap WAVES = Surface.waves(64, 64, 50e-9, 400e-9);
    private static final HeightMap NOISE = Surface.noise(64, 64, 50e-9, 400e-9, 9);

    @ParameterizedTest
    @CsvSource({
        "1e-6, COHERENT",
        "1e-6, ENSEMBLE",
        "3e-6, COHERENT",
        "5e-6, COHERENT",
        "5e-6, ENSEMBLE",
        "10e-6, COHERENT",
        "10e-6, ENSEMBLE",
        "30e-6, COHERENT",
        "65e-6, ENSEMBLE",
        "1e-3, COHERENT",
        "1e-3, ENSEMBLE"
    })
    void power(double coherenceLength, Average average) {
        List<Query> queries =
                new Directions(7).nearOrders(NOISE, CoherenceWindow.ofCoherenceLength(coherenceLength), 150);

        new Comparison(context, NOISE, Requests.of(coherenceLength, average))
                .powerErrors(queries)
                .assertWithin(TOLERANCE, "power");
    }

    @ParameterizedTest
    @CsvSource({"1e-6", "3e-6", "10e-6", "30e-6", "65e-6", "1e-3"})
    void powerOfASmoothSurface(double coherenceLength) {
        List<Query> queries =
                new Directions(7).nearOrders(WAVES, CoherenceWindow.ofCoherenceLength(coherenceLength), 150);

        new Comparison(context, WAVES, Requests.of(coherenceLength, Average.COHERENT))
                .powerErrors(queries)
                .assertWithin(TOLERANCE, "power");
    }

    @ParameterizedTest
    @CsvSource({"1e-6", "3e-6", "10e-6", "30e-6", "65e-6"})
    void colors(double coherenceLength) {
        new Comparison(context, NOISE, Requests.of(coherenceLength, Average.COHERENT))
                .colorErrors(new Directions(8).anywhere(20))
                .assertWithin(TOLERANCE, "XYZ");
    }

    @ParameterizedTest
    @CsvSource({"1e-6", "3e-6", "65e-6"})
    void aWindowOnTheCorner(double coherenceLength) {
        List<Query> queries =
                new Directions(10).nearOrders(NOISE, CoherenceWindow.ofCoherenceLength(coherenceLength), 100);

        new Comparison(
                        context,
                        NOISE,
                        Requests.of(coherenceLength, Average.COHERENT, WindowOrigin.CORNER, Optional.empty()))
                .powerErrors(queries)
                .assertWithin(TOLERANCE, "power");
    }
}
