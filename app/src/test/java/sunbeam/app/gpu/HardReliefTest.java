package sunbeam.app.gpu;

import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;

/** Heights that are hard to expand: the tolerance is kept on the GPU, in float32, by the plan's own choices. */
@NeedsDisplay
class HardReliefTest extends InAContext {
    private static final double PITCH = 50e-9;
    /** Of the patches of 64 samples, 3.2 um wide: as many bins as sunlight's window has on a measured skin. */
    private static final double WINDOW = 3.2e-6;

    @ParameterizedTest
    @CsvSource({
        "819e-9, COHERENT",
        "819e-9, ENSEMBLE",
        "2e-6, COHERENT",
        "2e-6, ENSEMBLE",
        "5e-6, COHERENT",
        "5e-6, ENSEMBLE"
    })
    void reliefOfManyWavelengths(double relief, Average average) {
        HeightMap map = Surface.noise(64, 64, PITCH, relief, 3);

        new Comparison(context, map, Requests.of(WINDOW, average))
                .powerErrors(new Directions(1).queries(80))
                .assertWithin(TOLERANCE, "power");
    }

    @ParameterizedTest
    @ValueSource(doubles = {819e-9, 2e-6, 5e-6})
    void colorsOfReliefOfManyWavelengths(double relief) {
        HeightMap map = Surface.noise(64, 64, PITCH, relief, 4);

        new Comparison(context, map, Requests.of(WINDOW, Average.COHERENT))
                .colorErrors(new Directions(2).anywhere(10))
                .assertWithin(TOLERANCE, "XYZ");
    }

    @Test
    void aScanThatSitsAMillimetreAboveZero() {
        HeightMap raised = Surface.noise(64, 64, PITCH, 819e-9, 6).map(height -> height + 1e-3);
        List<Query> queries = new Directions(4).queries(60);

        new Comparison(context, raised, Requests.of(WINDOW, Average.COHERENT))
                .powerErrors(queries)
                .assertWithin(TOLERANCE, "offset");
    }
}
