package sunbeam.app.scene;

import org.joml.Quaternionf;
import org.joml.Vector3f;

/** Motion of an animated scene about the vertical (z), counterclockwise from above. */
public enum Motion {
    /** Turns the model; light and camera stay. */
    TURNTABLE,
    /** Turns the environment or the key light; model and camera stay. */
    LIGHT_SWEEP;

    public Scene at(Scene scene, double radians) {
        return this == TURNTABLE
                ? turned(scene, new Quaternionf().rotationZ((float) radians))
                : lightTurned(scene, radians);
    }

    /** Returns a scene with its model turned further, about its center. */
    public static Scene turned(Scene scene, Quaternionf turn) {
        // Rounding errors add up over many turns.
        return scene.withOrientation(turn.mul(scene.orientation()).normalize());
    }

    /** Returns a scene with its environment, or else its key light, turned further, radians. */
    public static Scene lightTurned(Scene scene, double radians) {
        if (scene.hasEnvironment()) {
            double turn = scene.get(SceneSettings.ENVIRONMENT_ROTATION) + radians;
            return scene.with(SceneSettings.ENVIRONMENT_ROTATION, Math.IEEEremainder(turn, 2 * Math.PI));
        }
        SceneLight light = scene.light();
        return scene.withLight(light.pointing(light.towards().rotateZ((float) radians, new Vector3f())));
    }
}
