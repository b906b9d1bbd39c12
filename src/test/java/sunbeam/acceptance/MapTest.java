package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Shape of linear maps, and directions of the reflected light. */
class MapTest extends InOneWorkplace {
    // An odd size has a row of pixels at y = 0 and a column at x = 0, where gratings send their light.
    private static final int SIDE = 49;

    @Test
    void theLinearMapHasItsDocumentedShapeAndNoNumbersOutsideTheDisc() throws Exception {
        NpyImage map = map("blaze");

        assertThat(map.header()).contains("'descr': '<f4'", "'fortran_order': False", "'shape': (49, 49, 3)");
        assertThat(map.values()).hasSize(SIDE * SIDE * 3);
        for (int i = 0; i < map.values().length; i++) {
            float value = map.values()[i];
            int row = i / 3 / SIDE;
            assertThat(Float.isFinite(value))
                    .as("row %d, column %d: %s", row, i / 3 % SIDE, value)
                    .isEqualTo(map.inDisc(row, i / 3 % SIDE));
            assertThat(value < 0).isFalse();
        }
    }

    /** A ramp that rises towards +x tilts the mirror towards -x. Without the sign the light would be on the right. */
    @Test
    void theBlazedGratingSendsItsLightToTheLeft() throws Exception {
        NpyImage map = map("blaze");

        double left = map.luminance(azimuth -> Math.abs(azimuth) > 90);
        double right = map.luminance(azimuth -> Math.abs(azimuth) < 90);

        // In scalar theory sinc^2(k w H / 2 pi - m) of the light: over 0.9 for m = +1 near 500 nm, under 0.1 elsewhere.
        assertThat(left).isGreaterThan(5 * right);
        assertThat(map.luminance(azimuth -> Math.abs(azimuth) < 1 || Math.abs(azimuth) > 179))
                .as("on the horizontal")
                .isGreaterThan(0.99 * (left + right));
    }

    /** The fingers of Elaphe lie in rows along x, so its colors lie along the horizontal. */
    @Test
    void elapheHasItsColorsAlongTheHorizontal() throws Exception {
        // 0.79 and 0.82 measured; light without a preferred azimuth would have 0.17.
        assertThat(share(map("elaphe-like"), 0, 15)).isGreaterThan(0.6);
    }

    /** The rows of Xenopeltis are dense along y, so its colors lie above and below. */
    @Test
    void xenopeltisHasMostOfItsColorsNearTheVertical() throws Exception {
        NpyImage map = map(SharedData.patch("xenopeltis"));

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
    private static NpyImage map(Object patch) throws Exception {
        workplace.succeedHere(
                "brdf-map --patch %s --size 49 --wavelength-step 40nm --average coherent --tolerance 1e-2"
                        + " --force --output map.png --linear map.npy",
                patch);
        return NpyImage.read(workplace.resolve("map.npy"), SIDE);
    }
}
