package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import jrtr.ShaderException;

/** Active uniforms of a linked program, and all names that its shaders declare. */
final class GlUniforms {
    private static final Pattern DECLARATION = Pattern.compile("\\buniform\\b([^;{}]*)");
    private static final Pattern WORD = Pattern.compile("\\w+");

    private final String program;
    private final Set<String> declared = new HashSet<>();
    private final Map<String, GlUniform> active = new TreeMap<>();

    GlUniforms(GL3 gl, int name, String program, String sources) {
        this.program = program;
        // Unlike the driver, the text also has the names that the compiler optimized away or that an #if excludes.
        DECLARATION
                .matcher(sources)
                .results()
                .flatMap(found -> WORD.matcher(found.group(1)).results())
                .forEach(word -> declared.add(word.group()));
        int[] count = new int[2];
        gl.glGetProgramiv(name, GL3.GL_ACTIVE_UNIFORMS, count, 0);
        gl.glGetProgramiv(name, GL3.GL_ACTIVE_UNIFORM_MAX_LENGTH, count, 1);
        for (int index = 0; index < count[0]; index++) {
            GlUniform uniform = describe(gl, name, index, count[1]);
            if (uniform.location() >= 0) {
                active.put(uniform.name(), uniform);
            }
        }
    }

    private static GlUniform describe(GL3 gl, int program, int index, int maxLength) {
        byte[] bytes = new byte[Math.max(1, maxLength)];
        int[] lengthSizeType = new int[3];
        gl.glGetActiveUniform(
                program, index, bytes.length, lengthSizeType, 0, lengthSizeType, 1, lengthSizeType, 2, bytes, 0);
        String name = new String(bytes, 0, lengthSizeType[0], StandardCharsets.US_ASCII);
        boolean array = name.endsWith("[0]") || lengthSizeType[1] > 1;
        String plain = name.endsWith("[0]") ? name.substring(0, name.length() - 3) : name;
        return new GlUniform(plain, gl.glGetUniformLocation(program, name), lengthSizeType[2], array);
    }

    Map<String, GlUniform> active() {
        return active;
    }

    /** Returns the uniform of a name, or null if the shaders declare but do not use it; throws if they do not declare it. */
    GlUniform find(String name) {
        GlUniform uniform = active.get(name);
        if (uniform == null && !declared.contains(name.replaceFirst("[.\\[].*", ""))) {
            String known = active.values().stream().map(GlUniform::describe).collect(Collectors.joining(", "));
            throw new ShaderException(
                    program + " has no uniform '" + name + "'; it has: " + (known.isEmpty() ? "none" : known));
        }
        return uniform;
    }

    /** Returns the uniform as {@link #find} does; throws if its type is none of the given ones. */
    GlUniform findOfType(String name, String value, int... types) {
        GlUniform uniform = find(name);
        if (uniform == null || IntStream.of(types).anyMatch(type -> type == uniform.type())) {
            return uniform;
        }
        String hint = uniform.isSampler() ? "; bind a texture to it in the draw" : "";
        throw new ShaderException(program + ": uniform " + uniform.describe() + " cannot be set to a " + value + hint);
    }
}
