package jrtr.glsl;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import jrtr.GraphicsException;
import jrtr.ShaderSource;

/**
 * Parses the logs of GLSL compilers and maps each message to its line in the shader files. Known forms:
 *
 * <ul>
 * <li>Mesa: {@code 0:12(3): error: `x' undeclared}
 * <li>NVIDIA: {@code 0(12) : error C1503: undefined variable "x"}
 * <li>AMD, Intel on Windows, Apple: {@code ERROR: 0:12: 'x' : undeclared identifier}
 * </ul>
 *
 * Lines of any other form count only if no line has a known form; warnings do not count.
 */
public final class CompilerLog {
    private static final Pattern MESA =
            Pattern.compile("\\d+:(?<line>\\d+)\\(\\d+\\): [a-z ]*(?:error|warning): (?<message>.*)");
    private static final Pattern NVIDIA =
            Pattern.compile("\\d+\\((?<line>\\d+)\\) : [a-z ]*(?:error|warning) (?<message>.*)");
    private static final Pattern OTHERS = Pattern.compile("(?:ERROR|WARNING): \\d+:(?<line>\\d+): (?<message>.*)");
    private static final List<Pattern> FORMS = List.of(MESA, NVIDIA, OTHERS);
    private static final Pattern WARNING = Pattern.compile("(?i)\\bwarning\\b.*:");

    private CompilerLog() {}

    /**
     * Returns the exception for a failed step. Its message starts with {@code file:line:} of the first error and quotes that line; without
     * a known form of error, it starts with the shader's name.
     *
     * @param doing the failed step, such as "compiling full.frag.glsl"
     */
    public static GraphicsException failure(String doing, ShaderSource source, String log) {
        List<String> errors = log.replace("\0", "")
                .lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !WARNING.matcher(line).find())
                .toList();
        List<String> located =
                errors.stream().flatMap(line -> located(line, source).stream()).toList();
        List<String> problems = located.isEmpty()
                ? errors.stream().map(line -> source.name() + ": " + line).toList()
                : located;
        if (problems.isEmpty()) {
            return new GraphicsException(source.name() + ": the driver failed without a reason [" + doing + "]");
        }
        int more = problems.size() - 1;
        return new GraphicsException(
                problems.get(0) + " [" + doing + (more > 0 ? ", and " + more + " more" : "") + "]");
    }

    /** Describes an error at its line in the shader files; empty if the error has no line. */
    private static Optional<String> located(String error, ShaderSource source) {
        return FORMS.stream()
                .map(form -> form.matcher(error))
                .filter(Matcher::matches)
                .map(matcher -> originOf(matcher.group("line"), source).describe(matcher.group("message")))
                .findFirst();
    }

    /** Maps a line number to its origin. Numbers past the end, as for "unexpected end of file", map to the last line. */
    private static ShaderSource.Line originOf(String number, ShaderSource source) {
        int last = source.origins().size();
        // Anything of ten digits or more is past the end of every shader.
        int line = number.length() < 10 ? Integer.parseInt(number) : last;
        return source.origins().get(Math.max(1, Math.min(line, last)) - 1);
    }
}
