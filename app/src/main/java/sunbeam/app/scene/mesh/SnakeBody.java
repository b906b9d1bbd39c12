package sunbeam.app.scene.mesh;

import static sunbeam.app.scene.texture.ScaleRelief.BEGIN;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import sunbeam.app.scene.texture.BodyColors.SnakeHead;

/**
 * Body of the built-in snake: outline, center line, skin, and scales' positions. The parameter is the place along the body, 0 snout to 1
 * tip of the tail, proportional to length. The center line winds inwards from the tail on the ground for more than two turns, rises, and
 * winds back outwards over its own coils.
 */
public final class SnakeBody {
    // Largest half width of the body, meters.
    static final double RADIUS = 0.013;
    // Place where the head ends.
    static final double NECK = 0.045;

    // Squared half width over the place, in RADIUS^2; the snout is round.
    private static final Curve SQUARED_HEAD = new Curve(
            -0.0035, -0.22, 0, 0, 0.0035, 0.22, 0.0105, 0.44, 0.021, 0.64, 0.0275, 0.61, 0.0345, 0.49, NECK, 0.41);
    // Half width over the place, in RADIUS; beyond the tip, so that the tail is a cone.
    private static final Curve BODY = new Curve(
            NECK, 0.64, 0.11, 0.68, 0.25, 0.88, 0.42, 1, 0.58, 0.98, 0.76, 0.72, 0.9, 0.34, 1, 0.05, 1.1, -0.24);
    // Height over width: a flat head, a round neck, a body that sags a little.
    private static final Curve FLATNESS = new Curve(0, 0.72, 0.0225, 0.62, NECK, 0.86, 0.2, 0.9, 0.8, 0.92, 1, 1);

    // Distance from the z axis and lift, in RADIUS, over turns from the tail; coils overlap by a few percent.
    private static final Curve DISTANCE = new Curve(
            0, 7.26, 0.06, 6.5, 0.15, 6.1, 0.3, 5.97, 0.45, 5.73, 0.6, 5.46, 0.75, 5.35, 0.9, 5.34, 1.05, 5.03, 1.2,
            4.73, 1.35, 4.37, 1.5, 3.94, 1.65, 3.6, 1.8, 3.5, 1.9, 3.47, 2, 3.25, 2.15, 2.99, 2.3, 2.72, 2.6, 2.05,
            2.75, 1.9, 2.9, 2.2, 3.1, 3.3, 3.3, 5);
    private static final Curve LIFT = new Curve(0, 0, 2.12, 0, 2.4, 0.9, 2.65, 1.7, 3.05, 1.95, 3.3, 1.9);
    // Turns from which on neck and head are straight.
    private static final double STRAIGHT = 3.07;
    private static final double HEAD_LENGTH = 5 * RADIUS;
    // Place in front of which the center line keeps its height: the snout points forwards.
    private static final double CHIN = 0.017;
    private static final double STRETCH = 1.02;
    // Steps of numerical derivatives, large against rounding (1e-13) and small against the skin's features.
    private static final double PLACE_STEP = 2e-4;
    private static final double ANGLE_STEP = 1e-3;
    // Place of the eyes, and angle from the middle of the back.
    private static final double EYE = NECK * SnakeHead.EYE_ALONG;
    private static final double EYE_ANGLE = Math.PI * SnakeHead.EYE_AROUND;
    private static final int SAMPLES = 4000;
    private static final int HEAD_SAMPLES = 300;
    // In RADIUS; smaller scales would be invisible.
    private static final double NARROWEST = 0.2;

    /**
     * Center line and scales. A class of its own, so that {@link SnakeBody} is initialized before the loops call its methods: Java 17 now
     * and then passes NaN to a static method whose class is being initialized, which made one snake in a hundred black.
     */
    private static final class Spine {
        static final Spine OF_SNAKE = new Spine();
        private final Vector3d[] points = new Vector3d[SAMPLES + 1];
        // Meters from the snout to each point.
        private final double[] lengths = new double[SAMPLES + 1];
        // Numbers of scales from the neck, up to a factor: a scale's length follows the body's width.
        private final double[] scales = new double[SAMPLES + 1];

        private Spine() {
            Vector3d neck = spiral(STRAIGHT);
            Vector3d direction = new Vector3d(neck).sub(spiral(STRAIGHT - 1e-4)).normalize();
            for (int i = 0; i <= SAMPLES; i++) {
                double headward = HEAD_LENGTH * (HEAD_SAMPLES - i) / HEAD_SAMPLES;
                points[i] = i < HEAD_SAMPLES
                        ? new Vector3d(neck).fma(headward, direction)
                        : spiral(STRAIGHT * (SAMPLES - i) / (SAMPLES - HEAD_SAMPLES));
                lengths[i] = i == 0 ? 0 : lengths[i - 1] + points[i].distance(points[i - 1]);
            }
            for (int i = 1; i <= SAMPLES; i++) {
                double width = Math.max(NARROWEST, halfWidth(NECK + (1 - NECK) * (i - 0.5) / SAMPLES) / RADIUS);
                scales[i] = scales[i - 1] + 1 / (width * SAMPLES);
            }
        }
    }

    private SnakeBody() {}

    static double halfWidth(double place) {
        return RADIUS * (place < NECK ? Math.sqrt(SQUARED_HEAD.at(place)) : BODY.at(place));
    }

    static double halfHeight(double place) {
        return halfWidth(place) * FLATNESS.at(place);
    }

    /** The belly is flatter than the back. */
    static double bellyDepth(double place) {
        return 0.82 * halfHeight(place);
    }

    private static Vector3d spiral(double turns) {
        double angle = 2 * Math.PI * turns;
        double radius = RADIUS * DISTANCE.at(turns);
        return new Vector3d(STRETCH * radius * Math.cos(angle), radius * Math.sin(angle), RADIUS * LIFT.at(turns));
    }

    static double length() {
        return Spine.OF_SNAKE.lengths[SAMPLES];
    }

    /** Meters; high enough for the belly to lie on the ground. */
    static Vector3d center(double place) {
        Spine spine = Spine.OF_SNAKE;
        double wanted = place * length();
        int found = Arrays.binarySearch(spine.lengths, wanted);
        int low = Math.min(SAMPLES - 1, found < 0 ? -found - 2 : found);
        double t = (wanted - spine.lengths[low]) / (spine.lengths[low + 1] - spine.lengths[low]);
        return spine.points[low]
                .lerp(spine.points[low + 1], t, new Vector3d())
                .add(0, 0, bellyDepth(Math.max(place, CHIN)));
    }

    /** @param angle radians from the middle of the belly, to the right when looking towards the tail */
    static Vector3d point(double place, double angle) {
        Vector3d forward = direction(place);
        Vector3d right = new Vector3d(forward).cross(0, 0, 1).normalize();
        Vector3d up = right.cross(forward, new Vector3d());
        double upward = -Math.cos(angle);
        double height = upward > 0 ? halfHeight(place) : bellyDepth(place);
        double swell = 1 + eye(place, angle);
        Vector3d aside = right.mul(swell * halfWidth(place) * Math.sin(angle));
        return center(place).add(aside).add(up.mul(swell * height * upward));
    }

    static Vector3d direction(double place) {
        double before = Math.max(0, place - PLACE_STEP);
        double after = Math.min(1, place + PLACE_STEP);
        return center(after).sub(center(before)).normalize();
    }

    private static double eye(double place, double angle) {
        double side = Math.abs(Math.abs(angle - Math.PI) - EYE_ANGLE);
        double along = (place - EYE) / 0.0028;
        double across = side / Math.toRadians(17);
        double square = along * along + across * across;
        // A flat dome with a steep rim, in a shallow socket.
        return 0.1 * Math.exp(-square * square) - 0.03 * Math.exp(-square / 3);
    }

    static Mesh.Builder.Point frame(double place, double angle) {
        Vector3d along =
                point(Math.min(1, place + PLACE_STEP), angle).sub(point(Math.max(0, place - PLACE_STEP), angle));
        Vector3d around = point(place, angle + ANGLE_STEP).sub(point(place, angle - ANGLE_STEP));
        Vector3d normal = along.cross(around, new Vector3d()).normalize();
        Vector3d tangent =
                new Vector3d(normal).mul(-normal.dot(along)).add(along).normalize();
        return new Mesh.Builder.Point(point(place, angle), normal, tangent);
    }

    /** Grows by the same amount with each scale. */
    static double u(double place) {
        if (place <= NECK) {
            return BEGIN * place / NECK;
        }
        double at = SAMPLES * (place - NECK) / (1 - NECK);
        int below = Math.min(SAMPLES - 1, (int) at);
        double[] scales = Spine.OF_SNAKE.scales;
        double length = scales[below] + (at - below) * (scales[below + 1] - scales[below]);
        return BEGIN + (1 - BEGIN) * length / scales[SAMPLES];
    }

    /** Monotone function through points (Fritsch and Butland 1984), of zero slope at both ends, constant beyond. */
    private static final class Curve {
        private final double[] x;
        private final double[] y;
        private final double[] slope;

        Curve(double... points) {
            int count = points.length / 2;
            x = IntStream.range(0, count).mapToDouble(i -> points[2 * i]).toArray();
            y = IntStream.range(0, count).mapToDouble(i -> points[2 * i + 1]).toArray();
            slope = new double[count];
            for (int i = 1; i < count - 1; i++) {
                double before = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
                double after = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
                // The harmonic mean keeps the cubic monotone.
                slope[i] = before * after <= 0 ? 0 : 2 * before * after / (before + after);
            }
        }

        double at(double position) {
            double inside = Math.max(x[0], Math.min(x[x.length - 1], position));
            int i = 0;
            while (inside > x[i + 1]) {
                i++;
            }
            double width = x[i + 1] - x[i];
            double t = (inside - x[i]) / width;
            double rest = 1 - t;
            return y[i] * rest * rest * (1 + 2 * t)
                    + y[i + 1] * t * t * (3 - 2 * t)
                    + width * (slope[i] * t * rest * rest - slope[i + 1] * t * t * rest);
        }
    }
}
