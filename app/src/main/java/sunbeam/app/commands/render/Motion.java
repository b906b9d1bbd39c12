package sunbeam.app.commands.render;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;

/** The scenes of an animation's frames. */
final class Motion {
    static final AngleSweep ONCE_ROUND = new AngleSweep(0, 2 * Math.PI);

    private Motion() {}

    /** The light turned about the vertical, counter-clockwise seen from above, by angles from where the scene has it. */
    static List<Scene> lightSweep(Scene scene, AngleSweep sweep, int frames) {
        return IntStream.range(0, frames)
                .mapToObj(frame -> {
                    Vector3f towards = new Vector3f(scene.light().towards());
                    towards.rotateZ((float) sweep.at(frame, frames));
                    return scene.withLight(new SceneLight(towards, scene.light().intensity()));
                })
                .toList();
    }

    /** The mesh turned about the vertical, counter-clockwise seen from above; light and camera stay. */
    static List<Scene> turntable(Scene scene, AngleSweep turn, int frames) {
        return IntStream.range(0, frames)
                .mapToObj(frame -> {
                    Quaternionf rotation = new Quaternionf().rotationZ((float) turn.at(frame, frames));
                    return scene.withOrientation(
                            rotation.mul(scene.orientation()).normalize());
                })
                .toList();
    }
}
