package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import jrtr.GraphicsException;
import jrtr.glsl.FlatUniforms;

/** Active uniforms of a program, and all names that its shaders declare. Each sampler has a fixed texture unit. */
final class GlUniforms {
    private static final Pattern DECLARATION = Pattern.compile("\\buniform\\b([^;{}]*)");
    private static final Pattern WORD = Pattern.compile("\\w+");
    private static final Map<Integer, String> TYPES = Map.ofEntries(
            Map.entry(GL3.GL_SAMPLER_2D, "sampler2D"),
            Map.entry(GL3.GL_SAMPLER_2D_ARRAY, "sampler2DArray"),
            Map.entry(GL3.GL_FLOAT, "float"),
            Map.entry(GL3.GL_FLOAT_VEC2, "vec2"),
            Map.entry(GL3.GL_FLOAT_VEC3, "vec3"),
            Map.entry(GL3.GL_FLOAT_VEC4, "vec4"),
            Map.entry(GL3.GL_INT, "int"),
            Map.entry(GL3.GL_INT_VEC2, "ivec2"),
            Map.entry(GL3.GL_INT_VEC3, "ivec3"),
            Map.entry(GL3.GL_INT_VEC4, "ivec4"),
            Map.entry(GL3.GL_FLOAT_MAT3, "mat3"),
            Map.entry(GL3.GL_FLOAT_MAT4, "mat4"));

    /** @param name without {@code [0]} */
    private record Uniform(String name, int location, int type, boolean array) {
        /** Returns the texture target that this sampler reads; 0 for other types. */
        int samplerTarget() {
            return switch (type) {
                case GL3.GL_SAMPLER_2D -> GL3.GL_TEXTURE_2D;
                case GL3.GL_SAMPLER_2D_ARRAY -> GL3.GL_TEXTURE_2D_ARRAY;
                default -> 0;
            };
        }

        int components() {
            return FlatUniforms.components(typeName());
        }

        String describe() {
            return typeName() + (array ? "[] " : " ") + name;
        }

        private String typeName() {
            return TYPES.getOrDefault(type, "type 0x" + Integer.toHexString(type));
        }
    }

    private final String program;
    private final Set<String> declared = new HashSet<>();
    private final Map<String, Uniform> active = new TreeMap<>();
    private final Map<String, Integer> units = new LinkedHashMap<>();

    /** Reads the uniforms of a program and makes it current. */
    GlUniforms(GL3 gl, int name, String program, String sources) {
        this.program = program;
        // Unlike the driver, the text also has the names that the compiler optimized away or that an #if excludes.
        DECLARATION
                .matcher(sources)
                .results()
                .flatMap(found -> WORD.matcher(found.group(1)).results())
                .forEach(word -> declared.add(word.group()));
        gl.glUseProgram(name);
        int[] count = new int[2];
        gl.glGetProgramiv(name, GL3.GL_ACTIVE_UNIFORMS, count, 0);
        gl.glGetProgramiv(name, GL3.GL_ACTIVE_UNIFORM_MAX_LENGTH, count, 1);
        for (int index = 0; index < count[0]; index++) {
            Uniform uniform = describe(gl, name, index, count[1]);
            if (uniform.location >= 0) {
                active.put(uniform.name, uniform);
            }
        }
        for (Uniform uniform : active.values()) {
            boolean isSampler = uniform.samplerTarget() != 0;
            if (!TYPES.containsKey(uniform.type) || (isSampler && uniform.array)) {
                throw new GraphicsException(program + ": sampler " + uniform.describe()
                        + " is not supported; use sampler2D or sampler2DArray");
            }
            if (isSampler) {
                gl.glUniform1i(uniform.location, units.size());
                units.put(uniform.name, units.size());
            }
        }
    }

    private static Uniform describe(GL3 gl, int program, int index, int maxLength) {
        byte[] bytes = new byte[Math.max(1, maxLength)];
        int[] lengthSizeType = new int[3];
        gl.glGetActiveUniform(
                program, index, bytes.length, lengthSizeType, 0, lengthSizeType, 1, lengthSizeType, 2, bytes, 0);
        String name = new String(bytes, 0, lengthSizeType[0], StandardCharsets.US_ASCII);
        boolean array = name.endsWith("[0]") || lengthSizeType[1] > 1;
        String plain = name.endsWith("[0]") ? name.substring(0, name.length() - 3) : name;
        return new Uniform(plain, gl.glGetUniformLocation(program, name), lengthSizeType[2], array);
    }

    boolean isActive(String name) {
        return active.containsKey(name);
    }

    /** Returns the uniform of a name, or null if the shaders declare but do not use it; throws if they do not declare it. */
    private Uniform find(String name) {
        Uniform uniform = active.get(name);
        if (uniform == null && !declared.contains(name.replaceFirst("[.\\[].*", ""))) {
            String known = active.values().stream().map(Uniform::describe).collect(Collectors.joining(", "));
            throw new GraphicsException(
                    program + " has no uniform '" + name + "'; it has: " + (known.isEmpty() ? "none" : known));
        }
        return uniform;
    }

    void set(GL3 gl, String name, float[] values) {
        Uniform uniform = find(name);
        if (uniform == null) {
            return;
        }
        int count = elements(uniform, values.length);
        switch (uniform.type) {
            case GL3.GL_FLOAT -> gl.glUniform1fv(uniform.location, count, values, 0);
            case GL3.GL_FLOAT_VEC2 -> gl.glUniform2fv(uniform.location, count, values, 0);
            case GL3.GL_FLOAT_VEC3 -> gl.glUniform3fv(uniform.location, count, values, 0);
            case GL3.GL_FLOAT_VEC4 -> gl.glUniform4fv(uniform.location, count, values, 0);
            case GL3.GL_FLOAT_MAT3 -> gl.glUniformMatrix3fv(uniform.location, count, false, values, 0);
            case GL3.GL_FLOAT_MAT4 -> gl.glUniformMatrix4fv(uniform.location, count, false, values, 0);
            default -> throw wrongType(uniform, "floats");
        }
    }

    void set(GL3 gl, String name, int[] values) {
        Uniform uniform = find(name);
        if (uniform == null) {
            return;
        }
        int count = elements(uniform, values.length);
        switch (uniform.type) {
            case GL3.GL_INT -> gl.glUniform1iv(uniform.location, count, values, 0);
            case GL3.GL_INT_VEC2 -> gl.glUniform2iv(uniform.location, count, values, 0);
            case GL3.GL_INT_VEC3 -> gl.glUniform3iv(uniform.location, count, values, 0);
            case GL3.GL_INT_VEC4 -> gl.glUniform4iv(uniform.location, count, values, 0);
            default -> throw wrongType(uniform, "integers");
        }
    }

    private int elements(Uniform uniform, int values) {
        int components = uniform.components();
        if (values == 0 || values % components != 0 || (!uniform.array && values != components)) {
            throw new IllegalArgumentException(
                    program + ": " + values + " values for uniform " + uniform.describe() + " do not fit");
        }
        return values / components;
    }

    private GraphicsException wrongType(Uniform uniform, String values) {
        String hint = uniform.samplerTarget() != 0 ? "; bind a texture to it in the draw" : "";
        return new GraphicsException(
                program + ": uniform " + uniform.describe() + " cannot be set to " + values + hint);
    }

    void bind(GL3 gl, GlDevice device, Map<String, Texture> textures, FloatTarget target) {
        textures.forEach((sampler, texture) -> {
            texture.requireUsableBy(device);
            texture.requireUploaded();
            if (target.owns(texture)) {
                throw new IllegalStateException(
                        "target '" + target.label() + "' is drawn to and read as a texture in one draw");
            }
            Uniform uniform = find(sampler);
            if (uniform != null) {
                bind(gl, uniform, texture);
            }
        });
        for (String sampler : units.keySet()) {
            if (!textures.containsKey(sampler)) {
                throw new GraphicsException(program + ": no texture is bound to sampler '" + sampler + "'");
            }
        }
    }

    private void bind(GL3 gl, Uniform uniform, Texture texture) {
        if (uniform.samplerTarget() != texture.glTarget) {
            throw new GraphicsException(program + ": '" + texture.label() + "' is "
                    + (texture.isArray() ? "an array" : "no array") + " and cannot be bound to "
                    + uniform.describe());
        }
        gl.glActiveTexture(GL3.GL_TEXTURE0 + units.get(uniform.name));
        gl.glBindTexture(texture.glTarget, texture.glName());
    }
}
