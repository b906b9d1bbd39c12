package sunbeam.app.gpu;

import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleBiFunction;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;

/** Gratings whose orders have closed forms: the GPU against the formula, with no program of ours between. */
@NeedsDisplay
class GratingsOnGpuTest extends InAContext {
    private static final double PERIOD = 2.5e-6;
    // Ten periods: an order's neighbor is exp(-0.5 (1 / 0.064)^2) of it, nothing.
    private static final double WINDOW = 10 * PERIOD;

    /** Middles of the orders -3 to 3 at five wavelengths. */
    private static List<Query> orders() {
        List<Query> queries = new ArrayList<>();
        for (double wavelength = 380e-9; wavelength < 781e-9; wavelength += 100e-9) {
            for (int m = -3; m <= 3; m++) {
                queries.add(Directions.seeing(4, m / PERIOD, 0, wavelength));
            }
        }
        return queries;
    }

    /** @param power of an order, from its number and w / lambda */
    private static void assertOrders(HeightMap map, Average average, ToDoubleBiFunction<Integer, Double> power) {
        List<Query> queries = orders();
        List<float[]> computed = new Comparison(context, map, Requests.of(WINDOW, average)).spectral(queries);
        double[] errors = new double[queries.size()];
        for (int i = 0; i < errors.length; i++) {
            Query query = queries.get(i);
            double exact = power.applyAsDouble(i % 7 - 3, query.pair().w() / query.wavelength());
            errors[i] = Math.abs(computed.get(i)[average == Average.ENSEMBLE ? 1 : 0] - exact) / exact;
        }
        Errors.of(errors).assertWithin(TOLERANCE, "orders");
    }

    @ParameterizedTest
    // Not half of the period: even orders would vanish.
    @ValueSource(ints = {20, 31})
    void lamellarGratingHasItsClosedForm(int raised) {
        int samples = 64;
        double depth = 120e-9;
        HeightMap map =
                Surface.of(samples, 1, PERIOD / samples, (x, y) -> x < (raised - 0.5) * PERIOD / samples ? depth : 0);

        assertOrders(map, Average.COHERENT, (order, wPerWavelength) -> {
            // 1 + (e^(i phase) - 1) share for order 0; elsewhere the step's height times a Dirichlet kernel.
            double phase = 2 * Math.PI * wPerWavelength * depth;
            double share = (double) raised / samples;
            double step = 4 * Math.pow(Math.sin(phase / 2), 2);
            double angle = Math.PI * order / samples;
            return order == 0
                    ? 1 - share * (1 - share) * step
                    : step * Math.pow(Math.sin(raised * angle) / (samples * Math.sin(angle)), 2);
        });
    }

    @ParameterizedTest
    @ValueSource(doubles = {100e-9, 250e-9})
    void rampHasSincSquaredOrders(double height) {
        // Samples instead of a slope: a Dirichlet kernel, larger by offset^2 / (3 samples^2), 4e-5 at most here.
        int samples = 1024;
        HeightMap map = Surface.of(samples, 1, PERIOD / samples, (x, y) -> height * x / PERIOD);

        assertOrders(map, Average.COHERENT, (order, wPerWavelength) -> {
            // w is negative, so the bright order lies at positive u: the light leaves towards -x (docs/conventions.md).
            double offset = Math.PI * (height * wPerWavelength + order);
            return Math.pow(Math.sin(offset) / offset, 2);
        });
    }
}
