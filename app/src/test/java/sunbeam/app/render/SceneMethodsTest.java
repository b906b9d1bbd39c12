package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Arrays;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSettings.BodyAlpha;
import sunbeam.app.scene.Weights;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;

class SceneMethodsTest extends InAScene {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 56;

    private static Scene with(MethodType type) {
        return with(Choices.none().with(METHOD, type));
    }

    private static Scene with(Choices choices) {
        return blaze().withMethod(new SceneMethod(choices));
    }

    private float[] draw(Scene scene) {
        return drawn(scene, WIDTH, HEIGHT);
    }

    @Test
    void nmmHasTheColorsOfFull() {
        float[] full = draw(with(FullMethod.TYPE));
        float[] nmm = draw(with(NmmMethod.TYPE));
        int[] brightest = Arrays.copyOf(byLuminance(full), 200);
        double[] errors = Arrays.stream(brightest)
                .mapToDouble(i -> Math.abs(nmm[4 * i + 1] / full[4 * i + 1] - 1))
                .sorted()
                .toArray();
        // nmm takes an order's power at its one wavelength: 3e-3 on this grating's maps (docs/theory.md), up to
        // 6e-2 at the 95th percentile; beside the grating's plane, on orders' flanks, 1.5e-2 in the median.
        assertThat(errors[errors.length / 2]).as("median error").isLessThan(2e-2);
    }

    /** 101 wavelengths of 17 x 17 bins are 33 thousand steps of loops, of which Mesa's software renderer makes 65 thousand. */
    @Test
    void aPixelMayUseAsManyLoopStepsAsAPixelOfAMap() {
        Choices many = Choices.none()
                .with(METHOD, FullMethod.TYPE)
                .with(PRESET, Preset.THESIS)
                .with(MethodSettings.RADIUS, 8)
                .with(MethodSettings.WAVELENGTH_STEP, 4e-9);
        try (SceneSession session = session(with(many))) {
            // The session refuses partial sums.
            assertThat(session.draw(DrawRequest.ofPixels(session.scene(), 8, 6, Tile.whole(8, 6), 1))
                            .rgba())
                    .hasSize(4 * 8 * 6);
        }
    }

    @Test
    void theThesisPresetIsCoherentUnlessTheSceneNamesAnAverage() {
        Choices thesis = Choices.none().with(METHOD, FullMethod.TYPE).with(PRESET, Preset.THESIS);
        SceneMethod named = new SceneMethod(Choices.none().with(AVERAGE, Average.ENSEMBLE));

        assertThat(new SceneMethod(Choices.none()).with(thesis).get(AVERAGE)).isEqualTo(Average.COHERENT);
        assertThat(named.with(thesis).get(AVERAGE)).isEqualTo(Average.ENSEMBLE);
        assertThat(new SceneMethod(thesis).get(AVERAGE)).isEqualTo(Average.COHERENT);
    }

    /**
     * Without diffraction, alpha {@code light} hides nothing of the body; alpha {@code fresnel} hides the reflectance, 0.04 along the
     * normal.
     */
    @Test
    void theThesisAlphaHidesTheBodyWithoutDiffraction() {
        Scene body = with(FullMethod.TYPE).with(Weights.of(0, 1, 1, 0));
        Scene thesis = body.with(Weights.of(0, 1, 1, 0).with(SceneSettings.BODY_ALPHA, BodyAlpha.FRESNEL));
        float[] light = draw(body);
        float[] fresnel = draw(thesis);
        int middle = 4 * (WIDTH * HEIGHT / 2 + WIDTH / 2) + 1;
        // Half of the angle between light and view is 15 degrees: (1 - cos 15)^5 is 5e-8.
        assertThat(fresnel[middle] / light[middle]).isCloseTo(0.96f, within(1e-4f));
    }

    /** (1 - w) D + (1 + w) texture, whatever the light's angle; the texture is white. */
    @Test
    void theDraftsAlphaAddsTheTextureWithoutLight() {
        Scene scene = with(FullMethod.TYPE);
        int middle = 4 * (WIDTH * HEIGHT / 2 + WIDTH / 2) + 1;
        float lit = draw(scene.with(Weights.of(0, 1, 1, 0)))[middle];
        float diffracted = draw(scene.with(Weights.of(1, 0, 0, 0)))[middle];
        float draft =
                draw(scene.with(Weights.of(1, 1, 1, 0.2).with(SceneSettings.BODY_ALPHA, BodyAlpha.DRAFT)))[middle];
        assertThat(lit).isLessThan(0.95f);
        // All are float32.
        assertThat(draft).isCloseTo(0.8f * diffracted + 1.2f, within(1e-5f));
    }

    @Test
    void theDefaultMethodIsTableAndEachMethodHasADefaultTolerance() {
        Choices full = Choices.none().with(METHOD, FullMethod.TYPE);
        SceneMethod standard = new SceneMethod(Choices.none());
        assertThat(standard.type()).isEqualTo(TableMethod.TYPE);
        assertThat(standard.get(TOLERANCE)).isEqualTo(1e-2);
        assertThat(standard.get(AVERAGE)).isEqualTo(Average.ENSEMBLE);
        assertThat(standard.with(full).get(TOLERANCE)).isEqualTo(1e-3);
        assertThat(new SceneMethod(full).get(TOLERANCE)).isEqualTo(1e-3);
        SceneMethod named = new SceneMethod(Choices.none().with(TOLERANCE, 1e-2));
        assertThat(named.with(full).get(TOLERANCE))
                .as("named, if as the standard is")
                .isEqualTo(1e-2);
    }
}
