package sunbeam.app.commands.color;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;

class VerdictTest {
    private static final double SUNLIGHT = 65e-6;
    private static final Direction NORMAL = Direction.ofDegrees(0, 0);

    private static Patch patch(double[] heights, Patch.Repetition repetition) {
        HeightMap map = new HeightMap(128, 128, 100e-9, 100e-9, heights);
        List<String> none = List.of();
        return new Patch("scan", map, map, "made up", none, none, none, List.of(), Optional.empty(), repetition);
    }

    private static Patch noise() {
        SplittableRandom random = new SplittableRandom(7);
        double[] heights = new double[128 * 128];
        Arrays.setAll(heights, i -> 20e-9 * random.nextGaussian());
        return patch(heights, Patch.Repetition.NONE);
    }

    private static Verdict of(Patch patch) {
        return Verdict.of(patch, SurfaceOrder.of(patch), NORMAL, SUNLIGHT, false);
    }

    private static Verdict ofGrating(double period, double low, double high, Direction light) {
        SurfaceOrder order = new SurfaceOrder(
                new PrincipalDirection(0, OptionalDouble.empty(), 1),
                true,
                "",
                Optional.of(new SurfaceOrder.Grating(period, low, high, 0)));
        return Verdict.of(noise(), order, light, SUNLIGHT, false);
    }

    @Test
    void whatHasNoOrderHasNoColor() {
        assertThat(of(patch(new double[128 * 128], Patch.Repetition.NONE)))
                .isEqualTo(
                        new Verdict("A mirror: the relief is far below a wavelength, so that it has no color", false));
        assertThat(of(noise()).colored()).isFalse();
        assertThat(of(noise()).sentence()).startsWith("No order found");
    }

    /** A single period of a scan is waviness: its repetition is nobody's claim. */
    @Test
    void aScanOfOnePeriodShowsNoOrderUnlessItRepeats() {
        double[] heights = new double[128 * 128];
        Arrays.setAll(heights, i -> 100e-9 * Math.sin(2 * Math.PI * (i % 128) / 128.0));
        assertThat(of(patch(heights, Patch.Repetition.NONE)).colored()).isFalse();
        // 400 and 700 nm over 12.8 um.
        assertThat(of(patch(heights, Patch.Repetition.PERIODIC)).sentence())
                .startsWith("First-order colors: violet at 2 to red at 3 degrees, by lines 12.8 um apart");
    }

    @Test
    void lightThatIsCoherentOverTooLittleTellsNoColor() {
        Patch patch = noise();
        Verdict verdict = Verdict.of(patch, SurfaceOrder.of(patch), NORMAL, 500e-9, true);
        assertThat(verdict.colored()).isFalse();
        assertThat(verdict.sentence()).contains("coherent over only 500 nm");
    }

    @Test
    void theGratingEquationTellsTheAngles() {
        // asin(0.4) is 23.6 degrees, asin(0.7) 44.4.
        assertThat(ofGrating(1e-6, 1e-6, 1e-6, NORMAL).sentence())
                .isEqualTo("First-order colors: violet at 24 to red at 44 degrees, by lines 1 um apart across azimuth 0"
                        + " degrees");
        // asin(0.4 - 0.5) and asin(0.7 - 0.5).
        assertThat(ofGrating(1e-6, 1e-6, 1e-6, Direction.ofDegrees(30, 0)).sentence())
                .contains("violet at -6 to red at 12 degrees");
        // From the other side the order of the same sign goes past the horizon: asin(0.5 - 0.4), asin(0.5 - 0.7).
        assertThat(ofGrating(0.8e-6, 0.8e-6, 0.8e-6, Direction.ofDegrees(80, 180))
                        .sentence())
                .contains("violet at 29 to red at 6 degrees");
        // Light from beside: u = 0.4, v = -0.5.
        assertThat(ofGrating(1e-6, 1e-6, 1e-6, Direction.ofDegrees(30, 90)).sentence())
                .contains("violet at 40 to red at 59 degrees");
    }

    @Test
    void theAnglesAreNoSurerThanThePeriod() {
        // asin(0.4 / 1.25) and asin(0.7 / 0.8).
        assertThat(ofGrating(1e-6, 0.8e-6, 1.25e-6, NORMAL).sentence())
                .contains("violet at 19 to red at 61 degrees", "1.00 um (0.80 to 1.25)");
        assertThat(ofGrating(1e-6, 0.3e-6, 5e-6, NORMAL).sentence())
                .isEqualTo("Order found, but its period is uncertain (1.0 um (0.3 to 5.0)): so are the angles of its"
                        + " colors");
    }

    @Test
    void linesTooFineSendNoOrder() {
        Verdict verdict = ofGrating(200e-9, 200e-9, 200e-9, NORMAL);
        assertThat(verdict.colored()).isFalse();
        assertThat(verdict.sentence()).startsWith("No order of visible light: lines 0.200 um apart");
        // 400 nm / 450 nm is 62.7 degrees, and 80 degrees is 443 nm.
        assertThat(ofGrating(450e-9, 450e-9, 450e-9, NORMAL).sentence()).contains("violet at 63 to violet at 80");
    }
}
