package jrtr.glsl;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import jrtr.ShaderSource;
import jrtr.SourceLine;

/**
 * A full-screen shader that has its uniforms from the vertex shader, as inputs that are the same all over the triangle. Mesa's
 * software renderer gathers a uniform lane by lane wherever it is used, in some 25 instructions a component (Mesa 22.3); a flat
 * input it has at hand. Hardware reads uniforms for nothing.
 *
 * <p>What moves are lines that declare one {@code int}, {@code float}, vector or square matrix; arrays and samplers stay, and so does what
 * the driver has no room for.
 *
 * @param vertex the full-screen triangle, with the uniforms
 * @param fragment the shader, in which each uniform's name is a macro for its input
 */
public record FlatUniforms(ShaderSource vertex, ShaderSource fragment) {
    private static final String SUFFIX = "_perDraw";
    private static final Pattern UNIFORM =
            Pattern.compile("\\s*(uniform\\s+(int|ivec[234]|float|vec[234]|mat[234])\\s+(\\w+)\\s*(?:=[^;]*)?;)\\s*");
    private static final String MAIN = "void main()";

    /** One that may move. */
    private record Uniform(String declaration, String type, String name) {
        static Optional<Uniform> in(String line) {
            Matcher found = UNIFORM.matcher(line);
            return found.matches()
                    ? Optional.of(new Uniform(found.group(1), found.group(2), found.group(3)))
                    : Optional.empty();
        }

        int components() {
            char last = type.charAt(type.length() - 1);
            int size = Character.isDigit(last) ? last - '0' : 1;
            return type.startsWith("mat") ? size * size : size;
        }

        /** Of the fragment shader: two lines. */
        String input() {
            return "flat in " + type + " " + name + SUFFIX + ";\n#define " + name + " " + name + SUFFIX + "\n";
        }

        String output() {
            return declaration + " flat out " + type + " " + name + SUFFIX + "; ";
        }

        String assignment() {
            return name + SUFFIX + " = " + name + "; ";
        }
    }

    /**
     * Rewrites a pair of shaders.
     *
     * @param vertex without outputs; a line of it begins with {@code void main()}, and the next is its first
     * @param mostComponents that a vertex shader hands over
     */
    public static FlatUniforms of(ShaderSource vertex, ShaderSource fragment, int mostComponents) {
        Map<String, Uniform> moved = moved(fragment, mostComponents);
        return new FlatUniforms(withOutputs(vertex, moved), withInputs(fragment, moved));
    }

    private static Map<String, Uniform> moved(ShaderSource fragment, int mostComponents) {
        Map<String, Uniform> moved = new LinkedHashMap<>();
        int components = 0;
        for (String line : fragment.text().lines().toList()) {
            Optional<Uniform> uniform = Uniform.in(line);
            // What stands behind #if and again behind #else is one.
            if (uniform.isPresent() && !moved.containsKey(uniform.get().name())) {
                components += uniform.get().components();
                if (components <= mostComponents) {
                    moved.put(uniform.get().name(), uniform.get());
                }
            }
        }
        return moved;
    }

    private static ShaderSource withInputs(ShaderSource fragment, Map<String, Uniform> moved) {
        StringBuilder text = new StringBuilder();
        List<SourceLine> origins = new ArrayList<>();
        List<String> lines = fragment.text().lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            SourceLine origin = fragment.origins().get(i);
            Optional<Uniform> uniform = Uniform.in(lines.get(i)).filter(found -> moved.containsKey(found.name()));
            text.append(uniform.isPresent() ? uniform.get().input() : lines.get(i) + "\n");
            origins.add(origin);
            if (uniform.isPresent()) {
                origins.add(origin);
            }
        }
        return new ShaderSource(fragment.name(), text.toString(), origins);
    }

    private static ShaderSource withOutputs(ShaderSource vertex, Map<String, Uniform> moved) {
        int main = ("\n" + vertex.text()).indexOf("\n" + MAIN);
        if (main < 0) {
            throw new IllegalArgumentException("shader " + vertex.name() + " has no line that begins with " + MAIN);
        }
        int body = vertex.text().indexOf('\n', main);
        // On the lines that are there, so that messages name the right ones.
        String text = vertex.text().substring(0, main)
                + all(moved, Uniform::output)
                + vertex.text().substring(main, body)
                + all(moved, Uniform::assignment)
                + vertex.text().substring(body);
        return new ShaderSource(vertex.name(), text, vertex.origins());
    }

    private static String all(Map<String, Uniform> moved, Function<Uniform, String> part) {
        return moved.values().stream().map(part).collect(Collectors.joining());
    }
}
