package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;

/** Colors in the plane of a grating: near the specular direction orders are wide, and 380 and 780 nm cut them. */
@NeedsDisplay
class CutOrdersTest extends InAContext {
    private static final double PERIOD = 2.5e-6;
    private static final HeightMap BLAZE = Surface.of(64, 1, PERIOD / 64, (x, y) -> 250e-9 * x / PERIOD);

    @ParameterizedTest
    @ValueSource(doubles = {25e-6, 65e-6})
    void ordersAcrossTheEndsOfTheBand(double coherenceLength) {
        Direction light = Direction.ofDegrees(0, 0);
        List<DirectionPair> plane = IntStream.range(0, 60)
                .mapToObj(i -> new DirectionPair(light, Direction.ofDisc(-0.95 * (i + 0.5) / 60, 0)))
                .toList();

        Errors errors =
                new Comparison(context, BLAZE, Requests.of(coherenceLength, Average.COHERENT)).colorErrors(plane);

        errors.assertWithin(TOLERANCE, "XYZ");
        // A direction that sees nothing but the flank of an order outside the band is no exception.
        assertThat(errors.maximum()).as("%s", errors).isLessThan(20 * TOLERANCE);
    }
}
