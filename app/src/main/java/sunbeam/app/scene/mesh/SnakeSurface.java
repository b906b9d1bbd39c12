package sunbeam.app.scene.mesh;

import org.joml.Vector3d;
import sunbeam.app.scene.texture.SnakeHead;

/** Smooth skin of the snake without scales: points and frames by place along the body and angle around it. */
final class SnakeSurface {
    // Steps of the numerical derivatives, in shares of the body's length and in radians; large against rounding
    // (1e-13) and small against the skin's features.
    private static final double PLACE_STEP = 2e-4;
    private static final double ANGLE_STEP = 1e-3;

    // Center of the eyes: place along the body, and angle from the middle of the back.
    private static final double EYE = SnakeProfile.NECK * SnakeHead.EYE_ALONG;
    private static final double EYE_ANGLE = Math.PI * SnakeHead.EYE_AROUND;

    private final SnakeProfile profile = new SnakeProfile();
    private final SnakePath path = new SnakePath(profile);

    /** Position in meters, outward unit normal, and unit tangent towards the tail, orthogonal to the normal. */
    record Frame(Vector3d position, Vector3d normal, Vector3d tangent) {}

    double halfWidth(double place) {
        return profile.halfWidth(place);
    }

    /** @param angle radians from the middle of the belly, growing over the side that is right when looking towards the tail */
    Vector3d point(double place, double angle) {
        Vector3d forward = direction(place);
        Vector3d right = new Vector3d(forward).cross(0, 0, 1).normalize();
        Vector3d up = right.cross(forward, new Vector3d());
        double upward = -Math.cos(angle);
        double height = upward > 0 ? profile.halfHeight(place) : profile.bellyDepth(place);
        double swell = 1 + eye(place, angle);
        return path.at(place)
                .add(right.mul(swell * profile.halfWidth(place) * Math.sin(angle)))
                .add(up.mul(swell * height * upward));
    }

    Vector3d direction(double place) {
        double before = Math.max(0, place - PLACE_STEP);
        double after = Math.min(1, place + PLACE_STEP);
        return path.at(after).sub(path.at(before)).normalize();
    }

    private static double eye(double place, double angle) {
        double side = Math.abs(Math.abs(angle - Math.PI) - EYE_ANGLE);
        double along = (place - EYE) / 0.0028;
        double across = side / Math.toRadians(17);
        double square = along * along + across * across;
        // The fourth power of the distance gives a flat dome with a steep rim.
        return 0.13 * Math.exp(-square * square);
    }

    Frame frame(double place, double angle) {
        Vector3d along =
                point(Math.min(1, place + PLACE_STEP), angle).sub(point(Math.max(0, place - PLACE_STEP), angle));
        Vector3d around = point(place, angle + ANGLE_STEP).sub(point(place, angle - ANGLE_STEP));
        Vector3d normal = along.cross(around, new Vector3d()).normalize();
        Vector3d tangent =
                new Vector3d(normal).mul(-normal.dot(along)).add(along).normalize();
        return new Frame(point(place, angle), normal, tangent);
    }
}
