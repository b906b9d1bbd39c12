package jrtr;

import org.joml.Matrix3fc;
import org.joml.Matrix4fc;
import org.joml.Vector2fc;
import org.joml.Vector3fc;

/**
 * A linked pair of a vertex and a fragment shader with its uniforms. Values stay set until they are set again.
 *
 * <p>Every setter obeys the same rules. A name that the linked program uses is set. A name that the shaders declare but
 * that the compiler optimised away, or that lies behind an {@code #if} not taken, is ignored. Any other name is a {@link
 * ShaderException} that lists the names there are; so is a value of the wrong type. Samplers are not set here but bound
 * per draw, by {@link Binding}.
 *
 * <p>Matrices are column vectors' matrices as in GLSL and JOML: {@code M * v}.
 */
public interface ShaderProgram extends Resource {

    /** Sets a {@code float}. */
    void set(String name, float value);

    /** Sets an {@code int}. */
    void set(String name, int value);

    /** Sets a {@code vec2}. */
    void set(String name, Vector2fc value);

    /** Sets a {@code vec3}. */
    void set(String name, Vector3fc value);

    /** Sets a {@code mat3}. */
    void set(String name, Matrix3fc value);

    /** Sets a {@code mat4}. */
    void set(String name, Matrix4fc value);

    /**
     * Sets the first elements of a {@code float[]}, {@code vec2[]}, {@code vec3[]} or {@code vec4[]}, or one vector.
     *
     * @param values components one after the other; elements past the array's end are ignored
     * @throws IllegalArgumentException if empty or not a multiple of the type's components
     */
    void set(String name, float[] values);

    /**
     * Sets the first elements of an {@code int[]}, {@code ivec2[]}, {@code ivec3[]} or {@code ivec4[]}, or one vector.
     *
     * @param values components one after the other; elements past the array's end are ignored
     * @throws IllegalArgumentException if empty or not a multiple of the type's components
     */
    void set(String name, int[] values);

    /** Whether the linked program uses this uniform or sampler. */
    boolean isActive(String name);
}
