package sunbeam.app.render;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.setting.Choices;

/** Scenes of the plane, which fills the picture's middle; its patch is small, so that tables are made in a moment. */
final class PlaneScenes {
    static final Choices DIFFRACTION_ONLY = Weights.of(1, 0, 0, 0);

    private PlaneScenes() {}

    /** The blazed grating, viewed near its normal; the light sends orders to the camera. */
    static Scene blaze() {
        Choices own = Choices.none()
                .with(SceneSettings.TITLE, "plane")
                .with(SceneSettings.MESH, "plane")
                .with(SceneSettings.TEXTURE, "none")
                .with(SceneSettings.EXPOSURE, OptionalDouble.of(1))
                .with(SceneSettings.BACKGROUND, new SceneColor(0x204060))
                .over(DIFFRACTION_ONLY);
        return new Scene(
                own,
                PatchAtlas.of(PatchRequest.of("blaze")),
                new Viewpoint(
                        new Camera(new Vector3f(-0.05f, -0.1f, 0.4f), new Vector3f(), new Vector3f(0, 1, 0)),
                        Math.toRadians(40)),
                new Quaternionf(),
                new SceneLight(new Vector3f(-0.2f, 0.3f, 0.9f), 1),
                List.of(),
                new SceneMethod(Choices.none().with(Methods.METHOD, FullMethod.TYPE)));
    }

    static Choices around(Optional<SceneColor> ground, double sky, boolean shadows) {
        return Choices.none()
                .with(SceneSettings.GROUND, ground)
                .with(SceneSettings.SKY, sky)
                .with(SceneSettings.SHADOWS, shadows);
    }

    static SceneData load(Scene scene, Path folder) {
        return new SceneLoader(new Environment(Map.of(), folder), warning -> {})
                .parts(scene)
                .get(0);
    }
}
