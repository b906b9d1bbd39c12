package sunbeam.app.viewer;

import java.awt.Point;
import java.io.File;
import java.util.Optional;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.render.Pick;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.text.Text;

/** Point of the skin that the user has picked, in a scene of given camera, light and orientation. */
public record SkinPoint(Scene scene, Pick pick) {

    /** True if another scene has the same mesh, place, orientation map and patch map, so that the point is valid there. */
    public boolean staysIn(Scene other) {
        return scene.objects().size() == other.objects().size() && SceneSharing.sharesPoints(own(scene), own(other));
    }

    private Scene own(Scene any) {
        return any.at(pick.object());
    }

    /** Returns the same point of the mesh in a scene with another orientation or camera. */
    public SkinPoint in(Scene other) {
        Quaternionf turn = other.orientation().mul(scene.orientation().conjugate(new Quaternionf()), new Quaternionf());
        Vector3f position = pick.position().sub(pick.center(), new Vector3f());
        turn.transform(position).add(pick.center());
        Vector3f normal = turn.transform(pick.normal(), new Vector3f());
        double rotation =
                own(other).get(SceneSettings.ROTATE_PATCH) - own(scene).get(SceneSettings.ROTATE_PATCH);
        Quaternionf whole =
                new Quaternionf().rotateAxis((float) rotation, normal).mul(turn);
        Vector3f tangent = whole.transform(pick.tangent(), new Vector3f());
        Vector3f bitangent = whole.transform(pick.bitangent(), new Vector3f());
        Vector3f seen = other.view()
                .camera()
                .centerOfProjection()
                .sub(position, new Vector3f())
                .normalize();
        return new SkinPoint(
                other,
                new Pick(
                        position,
                        pick.object(),
                        pick.region(),
                        pick.center(),
                        tangent,
                        bitangent,
                        normal,
                        within(tangent, bitangent, normal, other.light().towards()),
                        within(tangent, bitangent, normal, seen)));
    }

    private static Direction within(Vector3fc tangent, Vector3fc bitangent, Vector3fc normal, Vector3fc direction) {
        return new Direction(tangent.dot(direction), bitangent.dot(direction), normal.dot(direction));
    }

    /** In the point's tangent frame. */
    public Direction light(Vector3fc towards) {
        return within(pick.tangent(), pick.bitangent(), pick.normal(), towards);
    }

    /** Returns the column and row of the point in a picture of the given size; they may lie outside the picture. */
    public Point pixel(int width, int height) {
        Vector3f seen = scene.view().camera().worldToCamera().transformPosition(pick.position(), new Vector3f());
        double perUnit = 0.5 * height / scene.view().halfHeight(width, height) / -seen.z;
        return new Point(
                (int) Math.floor(0.5 * width + perUnit * seen.x), (int) Math.floor(0.5 * height - perUnit * seen.y));
    }

    /** Returns {@link #pixel}; empty if the skin faces away from the viewer or lies behind the camera. Occlusion is not tested. */
    public Optional<Point> seen(int width, int height) {
        Vector3f seen = scene.view().camera().worldToCamera().transformPosition(pick.position(), new Vector3f());
        return seen.z < 0 && pick.wr().z() > 0 ? Optional.of(pixel(width, height)) : Optional.empty();
    }

    /** Describes the tangent frame and the angles to light and viewer, one quantity per line. */
    public String describe(Vector3fc towards, int width, int height) {
        Point pixel = pixel(width, height);
        Direction wi = light(towards);
        Direction wr = pick.wr();
        Vector3fc place = pick.position();
        return String.join(
                "\n",
                object() + Text.format("pixel      (%d, %d)", pixel.x, pixel.y),
                Text.format("position   (%.3g, %.3g, %.3g) m", place.x(), place.y(), place.z()),
                "tangent    " + vector(pick.tangent()),
                "bitangent  " + vector(pick.bitangent()),
                "normal     " + vector(pick.normal()),
                (scene.hasEnvironment() ? "brightest  " : "light      ")
                        + Text.format("theta %.1f°, phi %.1f°", theta(wi), phi(wi)),
                Text.format("viewer     theta %.1f°, phi %.1f°", theta(wr), phi(wr)),
                Text.format("u, v, w    %.3f, %.3f, %.3f", -wi.x() - wr.x(), -wi.y() - wr.y(), -wi.z() - wr.z()));
    }

    /** Returns a line that names the object, if there are several. */
    private String object() {
        int count = scene.objects().size();
        String name = new File(own(scene).mesh().name()).getName();
        return count == 1 ? "" : "object     " + (pick.object() + 1) + " of " + count + ", " + name + "\n";
    }

    private static double theta(Direction direction) {
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, direction.z()))));
    }

    private static double phi(Direction direction) {
        return Math.toDegrees(Math.atan2(direction.y(), direction.x()));
    }

    private static String vector(Vector3fc vector) {
        return Text.format("(%.3f, %.3f, %.3f)", vector.x(), vector.y(), vector.z());
    }
}
