package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.acceptance.NpyImage;
import sunbeam.acceptance.SharedData;
import sunbeam.acceptance.Workplace;

/** Directions of the reflected light under light along the normal, which depend on the signs of all conventions. */
class MapPatternTest {
    // An odd size has a row of pixels at y = 0 and a column at x = 0, where gratings send their light.
    private static final int SIDE = 49;

    @TempDir
    static Path root;

    private static Workplace workplace;

    @BeforeAll
    static void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    /** A ramp that rises towards +x tilts the mirror towards -x. Without the sign the light would be on the right. */
    @ParameterizedTest
    @ValueSource(strings = {"blaze"})
    void theBlazedGratingSendsItsLightToTheLeft(String patch) throws Exception {
        NpyImage map = map(patch);

        double left = map.luminance(azimuth -> Math.abs(azimuth) > 90);
        double right = map.luminance(azimuth -> Math.abs(azimuth) < 90);

        // In scalar theory sinc^2(k w H / 2 pi - m) of the light: over 0.9 for m = +1 near 500 nm, under 0.1 elsewhere.
        assertThat(left).isGreaterThan(5 * right);
        assertThat(map.luminance(azimuth -> Math.abs(azimuth) < 1 || Math.abs(azimuth) > 179))
                .as("on the horizontal")
                .isGreaterThan(0.99 * (left + right));
    }

    /** The fingers of Elaphe lie in rows along x, so its colors lie along the horizontal. */
    @ParameterizedTest
    @ValueSource(strings = {"elaphe-like"})
    void elapheHasItsColorsAlongTheHorizontal(String patch) throws Exception {
        // 0.79 and 0.82 measured; light without a preferred azimuth would have 0.17.
        assertThat(share(map(patch), 0, 15)).isGreaterThan(0.6);
    }

    /** The rows of Xenopeltis are dense along y, so its colors lie above and below. */
    @ParameterizedTest
    @ValueSource(strings = {"shared xenopeltis"})
    void xenopeltisHasMostOfItsColorsNearTheVertical(String patch) throws Exception {
        NpyImage map = map(patch);

        // 0.38 and 0.40 measured; light without a preferred azimuth would have 0.17.
        assertThat(share(map, 75, 90)).isGreaterThan(0.3).isGreaterThan(share(map, 0, 15));
    }

    /** Returns the share of light in a range of angles to the x axis, 0 to 90 degrees. */
    private static double share(NpyImage map, double from, double to) {
        double part = map.luminance(azimuth -> {
            double folded = Math.min(Math.abs(azimuth), 180 - Math.abs(azimuth));
            return folded >= from && folded <= to;
        });
        return part / map.luminance(azimuth -> true);
    }

    /** Draws a map with few wavelengths at a tolerance of 0.01, which suffice for directions. */
    private static NpyImage map(String patch) throws Exception {
        String source = patch.startsWith("shared ")
                ? SharedData.patch(patch.substring("shared ".length())).toString()
                : patch;
        String name = patch.replace(' ', '-');
        workplace.succeedHere(
                "brdf-map",
                "--patch=" + source,
                "--size=" + SIDE,
                "--wavelength-step=40nm",
                "--average=coherent",
                "--tolerance=1e-2",
                "--output=" + name + ".png",
                "--linear=" + name + ".npy");
        return NpyImage.read(workplace.resolve(name + ".npy"), SIDE);
    }
}
