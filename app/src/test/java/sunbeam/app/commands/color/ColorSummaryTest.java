package sunbeam.app.commands.color;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.PrincipalDirection;

final class ColorSummaryTest {
    @Test
    void anIntervalThatHoldsAllDirectionsIsToldAsNone() {
        assertThat(ColorSummary.direction(new PrincipalDirection(61, OptionalDouble.of(90), 0.1)))
                .isEqualTo("the scan tells no direction of most colour, along is drawn at azimuth 61 degrees");
        assertThat(ColorSummary.direction(new PrincipalDirection(69, OptionalDouble.of(31), 0.3)))
                .isEqualTo("direction of most colour at azimuth 69 +- 31 degrees (95 %)");
    }

    /** Beyond the range nobody has looked: there it may be purer. */
    @Test
    void aMaximumWhereTheRangeEndsIsToldAsOne() {
        assertThat(ColorSummary.angle(-79)).isEqualTo("-79 degrees");
        assertThat(ColorSummary.angle(-80)).startsWith("-80 degrees (the last one that was tried");
        assertThat(ColorSummary.angle(80)).startsWith("80 degrees (the last one that was tried");
    }
}
