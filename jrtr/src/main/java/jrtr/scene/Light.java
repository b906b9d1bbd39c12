package jrtr.scene;

import java.util.List;
import jrtr.gl.ShaderProgram;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Leaf of a scene graph: parallel rays, as from the sun. {@code towards} points from the scene to the light, with any length above 0, and is
 * normalized; the radiance is a linear color in the unit of the application's shaders.
 */
public record Light(Vector3fc towards, Vector3fc radiance) implements Node {
    /** Maximum number of lights in a scene, MAX_LIGHTS of jrtr/lights.glsl. */
    public static final int MOST = 8;

    public Light {
        towards = towards.div(towards.length(), new Vector3f());
    }

    /** Returns the light as seen from another space, to which an affine matrix leads. */
    Light transformed(Matrix4fc matrix) {
        return (matrix.properties() & Matrix4fc.PROPERTY_IDENTITY) != 0
                ? this
                : new Light(matrix.transformDirection(towards, new Vector3f()), radiance);
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
        program.set("lightCount", lights.size());
        program.set("lightDirections", directions);
        program.set("lightRadiances", radiances);
    }
}
