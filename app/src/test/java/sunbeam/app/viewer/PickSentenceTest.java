package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.color.ColorName;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

class PickSentenceTest {
    private static final double PERIOD = 1.54e-6;

    /** Where the grating equation sends an order of a wavelength, the light at 62 degrees, lines at 35 degrees of azimuth. */
    private static PickSentence sentence(int order, double wavelength, double period) {
        double azimuth = Math.toRadians(35);
        GratingPlane plane = new GratingPlane(Math.toRadians(-62), 0, azimuth);
        DirectionPair pair = plane.pair(plane.thetaR(order * wavelength / period));
        SpatialFrequency wave = new SpatialFrequency(Math.cos(azimuth) / period, Math.sin(azimuth) / period);
        return new PickSentence(pair.wi(), pair.wr(), List.of(wave), PickSentence.LEAST_SPREAD, false);
    }

    @ParameterizedTest
    @CsvSource({
        "1, 460, BLUE, 'blue, first order of 1.54 um; '",
        "1, 640, RED, 'red, first order of 1.54 um; '",
        "2, 530, GREEN, 'green, second order of 1.54 um; '",
        // Light of 460 nm is not red, wherever it comes from.
        "1, 460, RED, 'red; '",
        // Colors that are not of the spectrum, as where orders overlap, have no order.
        "1, 460, WHITE, 'white; '",
        "0, 460, WHITE, 'white, the mirror''s direction; '"
    })
    void theOrderIsThatOfTheGratingEquationForTheColor(int order, double nm, ColorName color, String words) {
        assertThat(sentence(order, nm * 1e-9, PERIOD).words(Optional.of(color)))
                .startsWith(words)
                .contains("light at 62 degrees, you at ");
    }

    @Test
    void itNamesTheAnglesToTheNormal() {
        Direction light = Direction.ofDegrees(62, 10);
        Direction viewer = Direction.ofDegrees(23, 200);
        PickSentence sentence = new PickSentence(light, viewer, List.of(), PickSentence.LEAST_SPREAD, false);
        assertThat(sentence.words(Optional.empty())).isEqualTo("light at 62 degrees, you at 23");
        assertThat(sentence.words(Optional.of(ColorName.DARK_GRAY)))
                .isEqualTo("dark gray; light at 62 degrees, you at 23");
        Direction below = new Direction(0.6, 0, -0.8);
        assertThat(new PickSentence(below, viewer, List.of(), 0, false).words(Optional.of(ColorName.BLACK)))
                .isEqualTo("black; the light is behind the skin here");
    }

    @Test
    void underAnEnvironmentTheLightIsItsBrightestAndHasNoOrder() {
        PickSentence one = sentence(1, 460e-9, PERIOD);
        PickSentence many = new PickSentence(one.light(), one.viewer(), one.waves(), one.spread(), true);
        assertThat(many.words(Optional.of(ColorName.BLUE))).startsWith("blue; brightest light at 62 degrees, you at ");
        PickSentence behind = new PickSentence(new Direction(0.6, 0, -0.8), one.viewer(), List.of(), 0, true);
        assertThat(behind.words(Optional.empty())).isEqualTo("the brightest light is behind the skin here");
    }

    @Test
    void aDirectionBesideTheOrdersPlaneHasNone() {
        PickSentence inPlane = sentence(1, 460e-9, PERIOD);
        Direction wr = inPlane.viewer();
        Direction aside = new Direction(wr.x() + 0.2, wr.y() - 0.2, 0.7);
        PickSentence beside = new PickSentence(inPlane.light(), aside, inPlane.waves(), inPlane.spread(), false);
        assertThat(beside.words(Optional.of(ColorName.BLUE))).startsWith("blue; ");
        assertThat(new PickSentence(inPlane.light(), aside, inPlane.waves(), 0.5, false)
                        .words(Optional.of(ColorName.BLUE)))
                .as("a rough skin spreads orders")
                .startsWith("blue, first order");
    }
}
