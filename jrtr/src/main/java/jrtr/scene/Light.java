package jrtr.scene;

import java.util.List;
import jrtr.gl.ShaderProgram;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Leaf of a scene graph: rays from a distant source, whose directions may have an elliptical Gaussian distribution.
 *
 * @param towards from the scene to the light; normalized from any length above 0
 * @param radiance linear color, in the unit of the application's shaders
 * @param deviation standard deviation of the directions along the shorter axis across the light's own, radians; 0 for parallel rays
 * @param stretch vector along the longer axis: the root of what the variance along it has more
 */
public record Light(Vector3fc towards, Vector3fc radiance, double deviation, Vector3fc stretch) implements Node {
    /** Maximum number of lights in a scene, MAX_LIGHTS of jrtr/lights.glsl. */
    public static final int MOST = 8;

    public Light {
        float length = towards.length();
        // A direction that is already normalized keeps its bits.
        towards = Math.abs(length - 1) < 1e-6f ? new Vector3f(towards) : towards.div(length, new Vector3f());
    }

    public Light(Vector3fc towards, Vector3fc radiance) {
        this(towards, radiance, 0, new Vector3f());
    }

    public Light withRadiance(Vector3fc value) {
        return new Light(towards, value, deviation, stretch);
    }

    /** Returns the light as seen from another space, to which a rotation leads. */
    Light transformed(Matrix4fc matrix) {
        return (matrix.properties() & Matrix4fc.PROPERTY_IDENTITY) != 0
                ? this
                : new Light(
                        matrix.transformDirection(towards, new Vector3f()),
                        radiance,
                        deviation,
                        matrix.transformDirection(stretch, new Vector3f()));
    }

    /** Sets the uniforms of jrtr/lights.glsl, which the program includes, for at most {@link #MOST} lights. */
    public static void apply(List<Light> lights, ShaderProgram program) {
        float[] directions = new float[3 * MOST];
        float[] radiances = new float[3 * MOST];
        for (int i = 0; i < lights.size(); i++) {
            for (int c = 0; c < 3; c++) {
                directions[3 * i + c] = lights.get(i).towards.get(c);
                radiances[3 * i + c] = lights.get(i).radiance.get(c);
            }
        }
        program.set("lightDirections", directions);
        program.set("lightRadiances", radiances);
    }
}
