package jrtr.glsl;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import jrtr.ShaderSource;

/**
 * Pair of shaders in which the vertex shader passes the fragment shader's uniforms as flat inputs. Mesa's software renderer gathers a
 * uniform lane by lane at each use, in about 25 instructions a component (Mesa 22.3); a flat input stays in registers. On hardware both
 * cost the same.
 *
 * <p>Only lines that declare one {@code int}, {@code float}, vector or square matrix are moved. Arrays, samplers and uniforms beyond the
 * driver's limit of varyings stay uniforms. In the fragment shader, all words that name a moved uniform get a suffix.
 */
public record FlatUniforms(ShaderSource vertex, ShaderSource fragment) {
    private static final String SUFFIX = "_perDraw";
    private static final Pattern UNIFORM =
            Pattern.compile("\\s*(uniform\\s+(int|ivec[234]|float|vec[234]|mat[234])\\s+(\\w+)\\s*(?:=[^;]*)?;)\\s*");
    private static final String MAIN = "void main()";

    private record Uniform(String declaration, String type, String name) {
        static Optional<Uniform> in(String line) {
            Matcher found = UNIFORM.matcher(line);
            return found.matches()
                    ? Optional.of(new Uniform(found.group(1), found.group(2), found.group(3)))
                    : Optional.empty();
        }
    }

    /** Returns the number of scalars of a type: a scalar, a vector or a square matrix. */
    public static int components(String type) {
        char last = type.charAt(type.length() - 1);
        int size = Character.isDigit(last) ? last - '0' : 1;
        return type.startsWith("mat") ? size * size : size;
    }

    /** Rewrites a vertex shader without outputs, a line of which begins with {@code void main()}, and its fragment shader. */
    public static FlatUniforms of(ShaderSource vertex, ShaderSource fragment, int mostComponents) {
        Map<String, Uniform> moved = moved(fragment, mostComponents);
        return new FlatUniforms(withOutputs(vertex, moved), withInputs(fragment, moved));
    }

    private static Map<String, Uniform> moved(ShaderSource fragment, int mostComponents) {
        Map<String, Uniform> moved = new LinkedHashMap<>();
        int components = 0;
        for (String line : fragment.text().lines().toList()) {
            Optional<Uniform> uniform = Uniform.in(line);
            // A uniform declared in both branches of an #if counts once.
            if (uniform.isPresent() && !moved.containsKey(uniform.get().name())) {
                components += components(uniform.get().type());
                if (components <= mostComponents) {
                    moved.put(uniform.get().name(), uniform.get());
                }
            }
        }
        return moved;
    }

    private static ShaderSource withInputs(ShaderSource fragment, Map<String, Uniform> moved) {
        String text = fragment.text()
                .lines()
                .map(line -> Uniform.in(line)
                        .filter(found -> moved.containsKey(found.name()))
                        .map(found -> "flat in " + found.type() + " " + found.name() + ";")
                        .orElse(line))
                .collect(Collectors.joining("\n", "", "\n"));
        if (!moved.isEmpty()) {
            text = text.replaceAll("\\b(" + String.join("|", moved.keySet()) + ")\\b", "$1" + SUFFIX);
        }
        return new ShaderSource(fragment.name(), text, fragment.origins());
    }

    private static ShaderSource withOutputs(ShaderSource vertex, Map<String, Uniform> moved) {
        int main = ("\n" + vertex.text()).indexOf("\n" + MAIN);
        int body = vertex.text().indexOf('\n', main);
        StringBuilder outputs = new StringBuilder();
        StringBuilder assignments = new StringBuilder();
        for (Uniform uniform : moved.values()) {
            String output = uniform.name + SUFFIX;
            outputs.append(uniform.declaration + " flat out " + uniform.type + " " + output + "; ");
            assignments.append(output + " = " + uniform.name + "; ");
        }
        // No line is added, so that line numbers in messages stay right.
        String text = vertex.text().substring(0, main)
                + outputs
                + vertex.text().substring(main, body)
                + assignments
                + vertex.text().substring(body);
        return new ShaderSource(vertex.name(), text, vertex.origins());
    }
}
