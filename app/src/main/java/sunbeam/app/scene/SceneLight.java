package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * A distant light: a point, or directions distributed as a Gaussian that has the variance of an even disc.
 *
 * @param towards from the scene to the light, world space; normalized from any length above 0
 * @param intensity factor of the light's radiance, at least 0
 * @param angularDiameter diameter of the disc in radians; 0 for a point
 */
public record SceneLight(Vector3fc towards, double intensity, double angularDiameter) {
    // Largest diameter of one footprint: the blur of a color table's widest level.
    private static final double WIDEST = Math.toRadians(9.5);
    private static final int RING = 6;
    // Distance of the ring's lights from the middle in deviations of one light; rows of Gaussians look even there.
    private static final double RING_DISTANCE = 2;

    public SceneLight {
        float length = towards.length();
        if (!(length > 0) || Float.isInfinite(length)) {
            throw new IllegalArgumentException("the light's direction (" + towards.x() + ", " + towards.y() + ", "
                    + towards.z() + ") has no direction");
        }
        // An already normalized direction keeps its bits: a scene read back equals the written one.
        towards = Math.abs(length - 1) < 1e-6f ? new Vector3f(towards) : towards.div(length, new Vector3f());
    }

    public SceneLight pointing(Vector3fc direction) {
        return new SceneLight(direction, intensity, angularDiameter);
    }

    /** Along either axis across the direction, radians. */
    public double deviation() {
        return angularDiameter / 4;
    }

    /** Returns lights of one footprint each that together have this variance: this one, or a middle and a ring of six. */
    public List<SceneLight> narrow() {
        if (angularDiameter <= WIDEST) {
            return List.of(this);
        }
        // A ring of radius d has the variance d^2 / 2 along either axis.
        double share = 1 / Math.sqrt(1 + RING / (RING + 1.0) * RING_DISTANCE * RING_DISTANCE / 2);
        SceneLight middle = new SceneLight(towards, intensity / (RING + 1), share * angularDiameter);
        List<SceneLight> lights = new ArrayList<>(List.of(middle));
        lights.addAll(middle.around(RING, RING_DISTANCE * middle.deviation()));
        return lights;
    }

    /** Returns lights like this one, evenly around its direction at an angle of the given tangent. */
    List<SceneLight> around(int count, double tangent) {
        Vector3f across = towards.cross(
                Math.abs(towards.x()) < 0.5 ? new Vector3f(1, 0, 0) : new Vector3f(0, 1, 0), new Vector3f());
        across.normalize((float) tangent);
        return IntStream.range(0, count)
                .mapToObj(i -> (float) (2 * Math.PI * i / count))
                .map(angle -> across.rotateAxis(angle, towards.x(), towards.y(), towards.z(), new Vector3f()))
                .map(aside -> pointing(aside.add(towards)))
                .toList();
    }
}
