package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import jrtr.Tile;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSettings.BodyAlpha;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Methods of scenes; light that adds up over several lights; ground, sky and shadows about a white sphere of 10 cm. */
class SceneMethodsTest extends InAScene {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 56;
    private static final int MIDDLE = 4 * (WIDTH * HEIGHT / 2 + WIDTH / 2) + 1;

    private static Scene with(MethodType type) {
        return with(Choices.none().with(METHOD, type));
    }

    private static Scene with(Choices choices) {
        return blaze().withMethod(new SceneMethod(choices));
    }

    private float[] draw(Scene scene) {
        return drawn(scene, WIDTH, HEIGHT);
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
        // Half of the angle between light and view is 15 degrees: (1 - cos 15)^5 is 5e-8.
        assertThat(fresnel[MIDDLE] / light[MIDDLE]).isCloseTo(0.96f, within(1e-4f));
    }

    /** (1 - w) D + (1 + w) texture, whatever the light's angle; the texture is white. */
    @Test
    void theDraftsAlphaAddsTheTextureWithoutLight() {
        Scene scene = with(FullMethod.TYPE);
        float lit = draw(scene.with(Weights.of(0, 1, 1, 0)))[MIDDLE];
        float diffracted = draw(scene.with(Weights.of(1, 0, 0, 0)))[MIDDLE];
        float draft =
                draw(scene.with(Weights.of(1, 1, 1, 0.2).with(SceneSettings.BODY_ALPHA, BodyAlpha.DRAFT)))[MIDDLE];
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

    private static final int SIZE = 64;
    private static final SceneLight KEY = new SceneLight(new Vector3f(-0.2f, 0.3f, 0.9f), 1, 0);
    private static final SceneLight FILL = new SceneLight(new Vector3f(0.5f, 0.1f, 0.6f), 0.4, Math.toRadians(12));
    private static final Choices AROUND = around(Optional.of(new SceneColor(0x907050)), 0.3, true);

    private static Scene scene(MethodType method) {
        return with(method).with(Weights.of(20, 1, 0.8, 0.2)).with(AROUND).withLight(KEY);
    }

    private void assertLightsAddUp(Scene scene) {
        float[] both = drawn(scene.withFillLights(List.of(FILL)), SIZE, SIZE);
        float[] key = drawn(scene, SIZE, SIZE);
        Scene alone = scene.withLight(FILL).with(Choices.none().with(SceneSettings.SHADOWS, false));
        float[] fill = drawn(alone, SIZE, SIZE);
        assertThat(both).isNotEqualTo(key);
        for (int i = 0; i < both.length; i++) {
            double sum = i % 4 == 3 ? key[i] : key[i] + fill[i];
            // float32 of the same three draws.
            assertThat((double) both[i]).isCloseTo(sum, within(1e-6 * Math.abs(sum)));
        }
    }

    @Test
    void colorsOfATableAndOfAMethodAddUp() {
        assertLightsAddUp(scene(TableMethod.TYPE));
        assertLightsAddUp(scene(FullMethod.TYPE));
    }

    @Test
    void movingPicturesShowFillLights() {
        Scene half = scene(TableMethod.TYPE)
                .with(Choices.none().with(SceneSettings.SHADOWS, false))
                .withLight(new SceneLight(KEY.towards(), 0.5, 0));
        int[] twice = moving(half.withFillLights(List.of(half.light())));
        int[] once = moving(half.withLight(KEY));
        assertThat(twice).isNotEqualTo(moving(half));
        // Rounding to 8 bits.
        assertAlike(twice, once, 1);
    }

    private int[] moving(Scene scene) {
        try (SceneSession session = session(scene)) {
            picture(session, SIZE, SIZE);
            return moving(session, SIZE, SIZE);
        }
    }

    @Test
    void aWideLightNeedsATableOfEnsembleAverages() {
        Scene coherent = with(Choices.none().with(METHOD, TableMethod.TYPE).with(AVERAGE, Average.COHERENT))
                .withLight(FILL);

        assertThatThrownBy(() -> load(coherent))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("angularDiameter; give ensemble");
    }

    private float[] draw(Choices around, UnaryOperator<Scene> change) {
        Viewpoint above = new Viewpoint(new Camera(new Vector3f(0, 0, 2), new Vector3f(), new Vector3f(0, 1, 0)), 0.4);
        Scene scene = blaze().withMesh(MeshSource.of("sphere"))
                .withView(above)
                .withLight(new SceneLight(new Vector3f(-1, 0, 1), 1, 0))
                .with(Weights.of(0, 1, 1, 0.2));
        return drawn(change.apply(scene.with(around)), SIZE, SIZE);
    }

    /** Luminance of the pixel that shows a point of the ground (by similar triangles, 2 m below the eye) or of the sphere. */
    private static float luminance(float[] drawn, double x, double y) {
        double scale = SIZE / (2 * 2.1 * Math.tan(0.2) * 4 / 3);
        int column = (int) (SIZE / 2.0 + scale * x);
        int row = (int) (SIZE / 2.0 - scale * y);
        return drawn[4 * (row * SIZE + column) + 1];
    }

    private static final Optional<SceneColor> WHITE = Optional.of(new SceneColor(0xffffff));
    private static final Choices NONE = around(Optional.empty(), 0, false);
    private static final Choices GROUND = around(WHITE, 0, false);

    @Test
    void aSphereShadesTheGroundBehindItAndNotBeforeIt() {
        float[] lit = draw(GROUND, scene -> scene);
        float[] shaded = draw(around(WHITE, 0, true), scene -> scene);
        // The shadow's middle is as far to the right as the sphere's is above the ground.
        assertThat(luminance(shaded, 0.16, 0)).isLessThan(0.4f * luminance(lit, 0.16, 0));
        assertThat(luminance(shaded, -0.16, 0)).isCloseTo(luminance(lit, -0.16, 0), within(1e-4f));
        assertThat(luminance(lit, -0.16, 0)).isGreaterThan(0.1f);
    }

    @Test
    void aConvexBodyShadesNothingOfItselfThatFacesTheLight() {
        float[] free = draw(NONE, scene -> scene);
        float[] shaded = draw(around(Optional.empty(), 0, true), scene -> scene);
        for (double x = -0.09; x < 0.04; x += 0.01) {
            assertThat(luminance(shaded, x, 0)).as("at %s", x).isCloseTo(luminance(free, x, 0), within(1e-4f));
        }
    }

    @Test
    void aSkyAddsWhatGlossReflects() {
        float[] dark = draw(NONE, scene -> scene.with(Weights.of(0, 1e-6, 1, 0)));
        float[] sky = draw(around(Optional.empty(), 1, false), scene -> scene.with(Weights.of(0, 1e-6, 1, 0)));
        // Keratin reflects 4 % along the normal, of a zenith of 1.
        assertThat(luminance(sky, 0, 0) - luminance(dark, 0, 0)).isCloseTo(0.04f, within(0.002f));
    }

    @Test
    void theGroundHidesTheBackground() {
        float[] drawn = draw(GROUND, scene -> scene);
        ScenePicture picture = new ScenePicture(SIZE, SIZE, drawn);
        DisplayTransform display = new DisplayTransform(1, Tone.CLIP);
        BufferedImage onBlack = PixelPicture.image(picture, display, new SceneColor(0));
        BufferedImage onRed = PixelPicture.image(picture, display, new SceneColor(0xff0000));
        for (int x = 0; x < SIZE; x++) {
            assertThat(onRed.getRGB(x, SIZE / 4)).as("column %d", x).isEqualTo(onBlack.getRGB(x, SIZE / 4));
        }
        assertThat(new Color(onBlack.getRGB(SIZE / 4, SIZE / 2)).getRed())
                .as("lit")
                .isPositive();
    }

    @Test
    void theThesisPresetHasNoSurroundings() {
        UnaryOperator<Scene> thesis =
                scene -> scene.with(Choices.none().with(METHOD, PqMethod.TYPE).with(PRESET, Preset.THESIS));
        assertThat(draw(around(WHITE, 1, true), thesis)).isEqualTo(draw(NONE, thesis));
    }
}
