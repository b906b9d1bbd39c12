package jrtr.glsl;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import jrtr.ShaderProblem;
import jrtr.ShaderSource;
import jrtr.SourceLine;

/**
 * Parses the logs of GLSL compilers and maps each message to its line in the shader files. Known forms:
 *
 * <ul>
 * <li>Mesa: {@code 0:12(3): error: `x' undeclared}
 * <li>NVIDIA: {@code 0(12) : error C1503: undefined variable "x"}
 * <li>AMD, Intel on Windows, Apple: {@code ERROR: 0:12: 'x' : undeclared identifier}
 * </ul>
 *
 * Lines of any other form become problems at line 0; they count only if no line has a known form.
 */
public final class CompilerLog {
    private static final Pattern MESA =
            Pattern.compile("\\d+:(?<line>\\d+)\\(\\d+\\): (?<kind>[a-z ]*(?:error|warning)): (?<message>.*)");
    private static final Pattern NVIDIA =
            Pattern.compile("\\d+\\((?<line>\\d+)\\) : (?<kind>[a-z ]*(?:error|warning)) (?<message>.*)");
    private static final Pattern OTHERS = Pattern.compile("(?<kind>ERROR|WARNING): \\d+:(?<line>\\d+): (?<message>.*)");
    private static final List<Pattern> FORMS = List.of(MESA, NVIDIA, OTHERS);

    private static final Pattern WARNING = Pattern.compile("(?i)\\bwarning\\b.*:");

    private CompilerLog() {}

    /**
     * Returns the errors in the log's order, without warnings. Errors without a line number are returned only if no error has one.
     */
    public static List<ShaderProblem> parse(String log, ShaderSource source) {
        List<ShaderProblem> withLine = new ArrayList<>();
        List<ShaderProblem> withoutLine = new ArrayList<>();
        log.replace("\0", "")
                .lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !WARNING.matcher(line).find())
                .forEach(line -> {
                    ShaderProblem problem = parseLine(line, source);
                    (problem.line() > 0 ? withLine : withoutLine).add(problem);
                });
        return withLine.isEmpty() ? withoutLine : withLine;
    }

    private static ShaderProblem parseLine(String line, ShaderSource source) {
        for (Pattern form : FORMS) {
            Matcher matcher = form.matcher(line);
            if (matcher.matches()) {
                return atPlace(matcher, source);
            }
        }
        return new ShaderProblem(source.name(), 0, line, "");
    }

    private static ShaderProblem atPlace(Matcher matcher, ShaderSource source) {
        SourceLine origin = originOf(matcher.group("line"), source);
        return new ShaderProblem(origin.file(), origin.number(), matcher.group("message"), origin.text());
    }

    /** Maps a line number to its origin. Numbers past the end, as for "unexpected end of file", map to the last line. */
    private static SourceLine originOf(String number, ShaderSource source) {
        int last = source.origins().size();
        // Anything of ten digits or more is past the end of every shader.
        int line = number.length() < 10 ? Integer.parseInt(number) : last;
        return source.origins().get(Math.max(1, Math.min(line, last)) - 1);
    }
}
