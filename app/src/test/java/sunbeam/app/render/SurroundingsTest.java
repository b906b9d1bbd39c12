package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.UnaryOperator;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;

/** Ground, sky and shadows about a white sphere of 10 cm that lies on the ground, in light from the left at 45 degrees. */
class SurroundingsTest extends InAScene {
    private static final int SIDE = 64;

    private float[] draw(Choices around, UnaryOperator<Scene> change) {
        Viewpoint above = new Viewpoint(new Camera(new Vector3f(0, 0, 2), new Vector3f(), new Vector3f(0, 1, 0)), 0.4);
        Scene scene = blaze().withMesh(MeshSource.of("sphere"))
                .withView(above)
                .withLight(new SceneLight(new Vector3f(-1, 0, 1), 1))
                .with(Weights.of(0, 1, 1, 0.2));
        return drawn(change.apply(scene.with(around)), SIDE, SIDE);
    }

    /** Luminance of the pixel that shows a point of the ground (by similar triangles, 2 m below the eye) or of the sphere. */
    private static float luminance(float[] drawn, double x, double y) {
        double scale = SIDE / (2 * 2.1 * Math.tan(0.2) * 4 / 3);
        int column = (int) (SIDE / 2.0 + scale * x);
        int row = (int) (SIDE / 2.0 - scale * y);
        return drawn[4 * (row * SIDE + column) + 1];
    }

    private static final Optional<SceneColor> WHITE = Optional.of(new SceneColor(0xffffff));
    private static final Choices NONE = around(Optional.empty(), 0, false);
    private static final Choices GROUND = around(WHITE, 0, false);
    private static final Choices SHADED = around(WHITE, 0, true);

    @Test
    void aSphereShadesTheGroundBehindItAndNotBeforeIt() {
        float[] lit = draw(GROUND, scene -> scene);
        float[] shaded = draw(SHADED, scene -> scene);
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
        ScenePicture picture = new ScenePicture(SIDE, SIDE, drawn);
        DisplayTransform display = new DisplayTransform(1, Tone.CLIP);
        BufferedImage onBlack = SceneDisplay.image(picture, 1, display, new SceneColor(0));
        BufferedImage onRed = SceneDisplay.image(picture, 1, display, new SceneColor(0xff0000));
        for (int x = 0; x < SIDE; x++) {
            assertThat(onRed.getRGB(x, SIDE / 4)).as("column %d", x).isEqualTo(onBlack.getRGB(x, SIDE / 4));
        }
        assertThat(new Color(onBlack.getRGB(SIDE / 4, SIDE / 2)).getRed())
                .as("lit")
                .isPositive();
    }

    @Test
    void theThesisPresetHasNoSurroundings() {
        UnaryOperator<Scene> thesis = scene -> scene.with(
                Choices.none().with(Methods.METHOD, PqMethod.TYPE).with(MethodSettings.PRESET, Preset.THESIS));
        assertThat(draw(around(WHITE, 1, true), thesis)).isEqualTo(draw(NONE, thesis));
    }
}
