package sunbeam.app.promise;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.LongStream;
import jrtr.gl.RenderContext;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.measure.errors.Certificate.Limits;

/** The promise of the tolerance on surfaces, windows and directions that nobody chose. */
@NeedsDisplay
class RandomCasesTest {
    private static final long FIRST_SEED = 500;
    private static final int CASES = 40;

    private static RenderContext context;

    @BeforeAll
    static void open() {
        context = RenderContext.offscreen();
    }

    @AfterAll
    static void close() {
        context.close();
    }

    /** The first of all cases, and some that once missed: loops that the driver ended, a chirp taken for rough. */
    static LongStream seeds() {
        return LongStream.concat(LongStream.range(FIRST_SEED, FIRST_SEED + CASES), LongStream.of(10046, 10074));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void theToleranceIsKeptOnWhateverIsDrawn(long seed) {
        RandomCase drawn = RandomCase.of(seed);

        RandomCase.Outcome outcome = drawn.measure(context);

        // The promise itself: median at most the tolerance, 95th percentile at most three times it.
        assertThat(Limits.of(drawn.tolerance()).hold(outcome.errors()))
                .as("%s: %s", drawn, outcome.errors())
                .isTrue();
    }
}
