package jrtr.glsl;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import jrtr.GraphicsException;
import jrtr.ShaderSource;

/** Single-use expansion of a root file by the rules of {@link ShaderLibrary}. */
final class IncludeExpansion {
    private static final String PROLOGUE_FILE = "<defines>";
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");
    private static final Pattern DIRECTIVE = Pattern.compile("\\s*#\\s*(include|version)\\b(.*)");
    private static final Pattern QUOTED_NAME = Pattern.compile("\\s*\"([^\"]+)\"\\s*");
    private static final Pattern DEFINE_IN_NAME = Pattern.compile("\\{([A-Za-z0-9_]*)}");

    private final ShaderLibrary library;
    private final Map<String, String> defines;
    private final StringBuilder text = new StringBuilder();
    private final List<ShaderSource.Line> origins = new ArrayList<>();
    private final Set<String> included = new HashSet<>();

    IncludeExpansion(ShaderLibrary library, Map<String, String> defines) {
        this.library = library;
        this.defines = new TreeMap<>(defines);
    }

    ShaderSource expand(String root) {
        included.add(root);
        appendFile(
                root,
                library.text(root)
                        .orElseThrow(() -> new GraphicsException("shader " + root + " is missing from the library")));
        return new ShaderSource(root, text.toString(), origins);
    }

    private void appendFile(String file, String content) {
        List<String> lines = content.lines().toList();
        // GLSL has no string literals, so comment marks always start a comment. Line breaks in comments stay.
        List<String> code = COMMENT.matcher(String.join("\n", lines))
                .replaceAll(comment -> comment.group().startsWith("/*")
                        ? " " + "\n".repeat((int) comment.group().lines().count() - 1)
                        : "")
                .lines()
                .toList();
        for (int index = 0; index < lines.size(); index++) {
            String stripped = index < code.size() ? code.get(index).stripTrailing() : "";
            appendLine(new ShaderSource.Line(file, index + 1, lines.get(index)), stripped);
        }
    }

    private void appendLine(ShaderSource.Line line, String code) {
        Matcher directive = DIRECTIVE.matcher(code);
        if (!directive.matches()) {
            emit(line, code);
        } else if (directive.group(1).equals("include")) {
            include(line, directive.group(2));
        } else {
            emit(line, code);
            int number = 1;
            for (Map.Entry<String, String> define : defines.entrySet()) {
                String text = ("#define " + define.getKey() + " " + define.getValue()).stripTrailing();
                emit(new ShaderSource.Line(PROLOGUE_FILE, number++, text), text);
            }
        }
    }

    private void include(ShaderSource.Line line, String argument) {
        Matcher quoted = QUOTED_NAME.matcher(argument);
        require(quoted.matches(), line, "#include needs a file name in double quotes");
        String name = DEFINE_IN_NAME.matcher(quoted.group(1)).replaceAll(match -> {
            String value = defines.get(match.group(1));
            require(value != null, line, "#include uses the define " + match.group(1) + ", which is not set");
            return Matcher.quoteReplacement(value);
        });
        if (included.add(name)) {
            String content = library.text(name).orElse(null);
            require(content != null, line, "included file " + name + " is missing from the shader library");
            appendFile(name, content);
        } else {
            emit(line, "");
        }
    }

    private void emit(ShaderSource.Line origin, String code) {
        text.append(code).append('\n');
        origins.add(origin);
    }

    private static void require(boolean condition, ShaderSource.Line line, String message) {
        if (!condition) {
            throw new GraphicsException(line.describe(message));
        }
    }
}
