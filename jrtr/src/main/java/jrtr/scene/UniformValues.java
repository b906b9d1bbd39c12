package jrtr.scene;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import jrtr.ShaderProgram;
import org.joml.Matrix3f;
import org.joml.Matrix3fc;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector2f;
import org.joml.Vector2fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.joml.Vector4f;
import org.joml.Vector4fc;

/**
 * Values for a program's uniforms, each with its type, kept until they are needed. Vectors, matrices and arrays are
 * copied. Names and types are checked by the program, by {@link ShaderProgram}'s rules, when the values are set.
 */
public final class UniformValues {
    private final Map<String, Consumer<ShaderProgram>> setters = new LinkedHashMap<>();

    /** No values yet. */
    public UniformValues() {}

    /** Keeps a {@code float}. */
    public UniformValues set(String name, float value) {
        return keep(name, program -> program.set(name, value));
    }

    /** Keeps an {@code int}. */
    public UniformValues set(String name, int value) {
        return keep(name, program -> program.set(name, value));
    }

    /** Keeps a {@code bool}. */
    public UniformValues set(String name, boolean value) {
        return keep(name, program -> program.set(name, value));
    }

    /** Keeps a {@code vec2}. */
    public UniformValues set(String name, Vector2fc value) {
        Vector2f copy = new Vector2f(value);
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps a {@code vec3}. */
    public UniformValues set(String name, Vector3fc value) {
        Vector3f copy = new Vector3f(value);
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps a {@code vec4}. */
    public UniformValues set(String name, Vector4fc value) {
        Vector4f copy = new Vector4f(value);
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps a {@code mat3}. */
    public UniformValues set(String name, Matrix3fc value) {
        Matrix3f copy = new Matrix3f(value);
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps a {@code mat4}. */
    public UniformValues set(String name, Matrix4fc value) {
        Matrix4f copy = new Matrix4f(value);
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps an array of floats or of float vectors. */
    public UniformValues set(String name, float[] values) {
        float[] copy = values.clone();
        return keep(name, program -> program.set(name, copy));
    }

    /** Keeps an array of ints or of int vectors. */
    public UniformValues set(String name, int[] values) {
        int[] copy = values.clone();
        return keep(name, program -> program.set(name, copy));
    }

    private UniformValues keep(String name, Consumer<ShaderProgram> setter) {
        setters.put(name, setter);
        return this;
    }

    /** Names that have a value, sorted. */
    public Set<String> names() {
        return new TreeSet<>(setters.keySet());
    }

    /**
     * Sets all values.
     *
     * @throws jrtr.ShaderException if the program has no such uniform or another type of it
     */
    public void applyTo(ShaderProgram program) {
        setters.values().forEach(setter -> setter.accept(program));
    }
}
