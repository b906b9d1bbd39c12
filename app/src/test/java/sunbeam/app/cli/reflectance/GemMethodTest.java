package sunbeam.app.cli.reflectance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.SettingException;

class GemMethodTest {
    @TempDir
    private Path home;

    @Test
    @NeedsDisplay
    void colorsFollowTheGratingEquation() {
        MethodProbe probe = new MethodProbe(home, "--patch blaze");
        // Spacing 1 um: the first order of 460 nm, 560 nm and 680 nm, and the dark between the orders.
        List<DirectionPair> directions = List.of(
                MethodProbe.inPlane(0, Math.toDegrees(Math.asin(0.46))),
                MethodProbe.inPlane(0, Math.toDegrees(Math.asin(0.58))),
                MethodProbe.inPlane(0, Math.toDegrees(Math.asin(0.68))),
                MethodProbe.inPlane(0, Math.toDegrees(Math.asin(0.30))),
                MethodProbe.inPlane(0, 0));
        List<float[]> xyz = probe.colors(directions, "--method gem --spacing 1um");
        assertThat(xyz.get(0)[2]).isGreaterThan(2 * xyz.get(0)[0]);
        assertThat(xyz.get(1)[1]).isGreaterThan(xyz.get(1)[0]).isGreaterThan(xyz.get(1)[2]);
        assertThat(xyz.get(2)[0]).isGreaterThan(xyz.get(2)[1]).isGreaterThan(xyz.get(2)[2]);
        assertThat(xyz.get(3)).startsWith(0, 0, 0);
        assertThat(xyz.get(4)[1]).isCloseTo(1, within(1e-5f));
    }

    /** The sum of the bumps in X, Y and Z over all orders with a visible wavelength, across the lines. */
    @Test
    @NeedsDisplay
    void theThesissFormIsALineOfAllVisibleOrders() {
        MethodProbe probe = new MethodProbe(home, "--patch blaze");
        double u = 0.75;
        double angle = Math.toDegrees(Math.asin(u));
        List<DirectionPair> directions = List.of(
                MethodProbe.inPlane(0, angle),
                new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(angle, 1)),
                MethodProbe.inPlane(0, 0));
        List<float[]> xyz = probe.colors(directions, "--method gem --preset thesis");
        double slope = 1.5 * u / (1 + Math.sqrt(1 - u * u));
        double[] white = {0.95047, 1, 1.08883};
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int order = 1; order <= 13; order++) {
                double place = (2500 * u / order - 380) / 400;
                sum += Math.max(0, 1 - Math.pow(4 * place - 3 + c, 2));
            }
            // The display curve of exponent 1 / 2.4 makes exp(-slope^2) out of this factor; computed in float32.
            double expected = 0.1 * white[c] * sum * Math.exp(-2.4 * slope * slope);
            assertThat((double) xyz.get(0)[c]).isCloseTo(expected, within(1e-4 * white[c]));
        }
        assertThat(xyz.get(0)[1]).isGreaterThan(0.01f);
        assertThat(xyz.get(1)).startsWith(0, 0, 0);
        assertThat(xyz.get(2)[1]).isCloseTo(1, within(1e-5f));
    }

    @Test
    void aPatchOfManyPeriodsNeedsASpacing() {
        MethodProbe probe = new MethodProbe(home, "--patch disc");
        assertThatThrownBy(() -> probe.plan(VisibleRange.all(), "--method gem"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--spacing");
        assertThat(probe.plan(VisibleRange.all(), "--method gem --spacing 1.6um")
                        .summary())
                .contains("1.6 um")
                .contains("for comparison only");
    }
}
