package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Map;

/**
 * Active uniform of a linked program.
 *
 * @param name without {@code [0]}
 * @param location OpenGL's handle for setting it
 */
record GlUniform(String name, int location, int type, boolean array) {

    private static final Map<Integer, String> NUMERIC_TYPES = Map.ofEntries(
            Map.entry(GL3.GL_FLOAT, "float"),
            Map.entry(GL3.GL_FLOAT_VEC2, "vec2"),
            Map.entry(GL3.GL_FLOAT_VEC3, "vec3"),
            Map.entry(GL3.GL_FLOAT_VEC4, "vec4"),
            Map.entry(GL3.GL_INT, "int"),
            Map.entry(GL3.GL_INT_VEC2, "ivec2"),
            Map.entry(GL3.GL_INT_VEC3, "ivec3"),
            Map.entry(GL3.GL_INT_VEC4, "ivec4"),
            Map.entry(GL3.GL_BOOL, "bool"),
            Map.entry(GL3.GL_UNSIGNED_INT, "uint"),
            Map.entry(GL3.GL_FLOAT_MAT2, "mat2"),
            Map.entry(GL3.GL_FLOAT_MAT3, "mat3"),
            Map.entry(GL3.GL_FLOAT_MAT4, "mat4"));

    /** True for every type that is not a number, vector or matrix. */
    boolean isSampler() {
        return !NUMERIC_TYPES.containsKey(type);
    }

    /** Returns the texture target that this sampler reads, or 0 if the engine has no such textures. */
    int samplerTarget() {
        return switch (type) {
            case GL3.GL_SAMPLER_2D -> GL3.GL_TEXTURE_2D;
            case GL3.GL_SAMPLER_2D_ARRAY -> GL3.GL_TEXTURE_2D_ARRAY;
            default -> 0;
        };
    }

    int components() {
        char last = typeName().charAt(typeName().length() - 1);
        return Character.isDigit(last) ? last - '0' : 1;
    }

    /** Returns the type as in GLSL, with brackets for an array, and the name. */
    String describe() {
        return typeName() + (array ? "[] " : " ") + name;
    }

    private String typeName() {
        return switch (type) {
            case GL3.GL_SAMPLER_2D -> "sampler2D";
            case GL3.GL_SAMPLER_2D_ARRAY -> "sampler2DArray";
            default -> NUMERIC_TYPES.getOrDefault(type, "type " + GlNames.hex(type));
        };
    }
}
