package sunbeam.app.scene;

import org.joml.Quaternionf;
import org.joml.Vector3f;

/** Motion of an animated scene about the vertical (z), counterclockwise from above. */
public enum Motion {
    /** Light and camera stay. */
    TURNTABLE,
    /** Mesh and camera stay. */
    LIGHT_SWEEP;

    public Scene at(Scene scene, double radians) {
        if (this == TURNTABLE) {
            Quaternionf turn = new Quaternionf().rotationZ((float) radians);
            return scene.withOrientation(turn.mul(scene.orientation()).normalize());
        }
        Vector3f towards = new Vector3f(scene.light().towards()).rotateZ((float) radians);
        return scene.withLight(scene.light().pointing(towards));
    }
}
