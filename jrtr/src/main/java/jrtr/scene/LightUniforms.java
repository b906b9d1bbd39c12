package jrtr.scene;

import java.util.List;
import jrtr.gl.ShaderProgram;
import org.joml.Vector3fc;

/** Uniform values of jrtr/lights.glsl. */
public final class LightUniforms {
    /** Maximum number of lights in a scene, MAX_LIGHTS of jrtr/lights.glsl. */
    public static final int MOST = 8;

    private final int count;
    private final float[] directions = new float[3 * MOST];
    private final float[] radiances = new float[3 * MOST];

    private LightUniforms(List<Light> lights) {
        this.count = lights.size();
        for (int i = 0; i < count; i++) {
            put(directions, i, lights.get(i).towards());
            put(radiances, i, lights.get(i).radiance());
        }
    }

    private static void put(float[] values, int index, Vector3fc vector) {
        values[3 * index] = vector.x();
        values[3 * index + 1] = vector.y();
        values[3 * index + 2] = vector.z();
    }

    /**
     * Converts a scene's lights.
     *
     * @throws IllegalArgumentException if there are more than {@link #MOST}
     */
    public static LightUniforms of(List<Light> lights) {
        if (lights.size() > MOST) {
            throw new IllegalArgumentException(
                    "the scene has " + lights.size() + " lights, but shaders take at most " + MOST);
        }
        return new LightUniforms(lights);
    }

    public void applyTo(ShaderProgram program) {
        if (program.isActive("lightCount")) {
            program.set("lightCount", count);
        }
        if (program.isActive("lightDirections")) {
            program.set("lightDirections", directions);
        }
        if (program.isActive("lightRadiances")) {
            program.set("lightRadiances", radiances);
        }
    }
}
