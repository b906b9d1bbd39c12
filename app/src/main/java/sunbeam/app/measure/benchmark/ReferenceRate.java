package sunbeam.app.measure.benchmark;

import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** How fast the exact reference is: directions times wavelengths per second, both averages of the power each. */
final class ReferenceRate {
    private static final int SAMPLES = 24;

    private ReferenceRate() {}

    static double measure(ReferenceEvaluator evaluator) {
        evaluate(evaluator);
        long start = System.nanoTime();
        evaluate(evaluator);
        return SAMPLES / ((System.nanoTime() - start) * 1e-9);
    }

    private static void evaluate(ReferenceEvaluator evaluator) {
        IntStream.range(0, SAMPLES).parallel().forEach(i -> {
            Direction light = Direction.ofDegrees(2.0 * i, 15.0 * i);
            Direction view = Direction.ofDegrees(70 - 2.0 * i, 11.0 * i);
            evaluator.powers(new DirectionPair(light, view), 400e-9 + 10e-9 * i);
        });
    }
}
