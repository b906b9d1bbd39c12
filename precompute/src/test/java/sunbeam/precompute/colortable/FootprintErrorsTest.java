package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What is said of a mesh's table. */
class FootprintErrorsTest {
    private static List<double[]> colors(double factorInTheDark) {
        return IntStream.range(0, 100)
                .mapToObj(i -> i < 50
                        ? new double[] {1e-6 * factorInTheDark, 1e-6, 1e-6}
                        : new double[] {1e-3, 2e-3, 1e-3 * 1.001})
                .toList();
    }

    @Test
    void aMissSaysWhichHalfMisses() {
        FootprintErrors errors = FootprintErrors.of(colors(1.2), colors(1));
        assertThat(errors.darker().median()).isBetween(0.19, 0.21);
        assertThat(errors.brighter().median()).isLessThan(1e-9);
        assertThat(errors.miss(1e-2)).isPresent();
        assertThat(errors.miss(0.3)).isEmpty();
    }

    @Test
    void whatIsDarkerThanAnythingPromisedDoesNotCount() {
        List<double[]> none = List.of(new double[] {0, 0, 0}, new double[] {1e-10, 0, 0});
        FootprintErrors errors = FootprintErrors.of(none, none);
        assertThat(errors.all().count()).isZero();
        assertThat(errors.miss(1e-5)).isEmpty();
    }
}
