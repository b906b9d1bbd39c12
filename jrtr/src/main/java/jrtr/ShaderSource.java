package jrtr;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Complete text of one shader stage, ASCII with lines that end with {@code \n}, with expanded includes and the origin of each line. {@link
 * jrtr.glsl.ShaderLibrary#load} creates it.
 */
public record ShaderSource(String name, String text, List<Line> origins) {
    // Forms of the messages of Mesa, of NVIDIA, and of AMD, Intel on Windows and Apple.
    private static final List<Pattern> FORMS = List.of(
            Pattern.compile("\\d+:(?<line>\\d+)\\(\\d+\\): [a-z ]*(?:error|warning): (?<message>.*)"),
            Pattern.compile("\\d+\\((?<line>\\d+)\\) : [a-z ]*(?:error|warning) (?<message>.*)"),
            Pattern.compile("(?:ERROR|WARNING): \\d+:(?<line>\\d+): (?<message>.*)"));
    private static final Pattern WARNING = Pattern.compile("(?i)\\bwarning\\b.*:");

    /** Line of a shader file, or of the generated {@code <defines>}, before include expansion; numbers count from 1. */
    public record Line(String file, int number, String text) {
        public String describe(String message) {
            return file + ":" + number + ": " + message + (text.isBlank() ? "" : ": `" + text.strip() + "`");
        }
    }

    /**
     * Returns the exception for a failed step of the driver. Its message starts with {@code file:line:} of the first error and quotes that
     * line. If no error has a known form, it starts with the shader's name. Warnings do not count.
     *
     * @param doing the failed step, such as "compiling full.frag.glsl"
     */
    public GraphicsException failure(String doing, String log) {
        List<String> errors = log.replace("\0", "")
                .lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !WARNING.matcher(line).find())
                .toList();
        List<String> located =
                errors.stream().flatMap(line -> located(line).stream()).toList();
        List<String> problems = located.isEmpty()
                ? errors.stream().map(line -> name + ": " + line).toList()
                : located;
        if (problems.isEmpty()) {
            return new GraphicsException(name + ": the driver failed without a reason [" + doing + "]");
        }
        int more = problems.size() - 1;
        return new GraphicsException(
                problems.get(0) + " [" + doing + (more > 0 ? ", and " + more + " more" : "") + "]");
    }

    private Optional<String> located(String error) {
        return FORMS.stream()
                .map(form -> form.matcher(error))
                .filter(Matcher::matches)
                .map(found -> origin(found.group("line")).describe(found.group("message")))
                .findFirst();
    }

    /** Numbers past the end, as for "unexpected end of file", and of ten digits or more mean the last line. */
    private Line origin(String number) {
        int line = number.length() < 10 ? Integer.parseInt(number) : origins.size();
        return origins.get(Math.max(1, Math.min(line, origins.size())) - 1);
    }
}
