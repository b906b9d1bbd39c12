package jrtr.glsl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
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
    static final String PROLOGUE_FILE = "<defines>";

    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");
    private static final Pattern DIRECTIVE = Pattern.compile("\\s*#\\s*([a-z]+)\\b(.*)");
    private static final Pattern QUOTED_NAME = Pattern.compile("\\s*\"([^\"]+)\"\\s*");
    private static final Pattern DEFINE_IN_NAME = Pattern.compile("\\{([A-Za-z0-9_]*)}");
    private static final Pattern DEFINE = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");
    private static final Pattern SAFE_NAME = Pattern.compile("[A-Za-z0-9_.-]+(/[A-Za-z0-9_.-]+)*");

    private final ShaderLibrary library;
    private final Map<String, String> defines;
    private final StringBuilder text = new StringBuilder();
    private final List<ShaderSource.Line> origins = new ArrayList<>();
    private final Set<String> included = new HashSet<>();
    private final Deque<String> openFiles = new ArrayDeque<>();
    private boolean versionSeen;

    IncludeExpansion(ShaderLibrary library, Map<String, String> defines) {
        this.library = library;
        this.defines = defines;
    }

    ShaderSource expand(String root) {
        checkName(root, "shader ");
        String content = library.text(root)
                .orElseThrow(() -> new GraphicsException("shader " + root + " is missing from the shader library"));
        appendFile(root, content);
        if (!versionSeen) {
            throw new GraphicsException(root + ":1: a shader must begin with #version, such as `#version 330 core`");
        }
        return new ShaderSource(root, text.toString(), origins);
    }

    private void appendFile(String file, String content) {
        openFiles.push(file);
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
            if (stripped.contains("/*")) {
                throw new GraphicsException(file + ":" + lines.size() + ": a comment /* is never closed");
            }
            appendLine(new ShaderSource.Line(file, index + 1, lines.get(index)), stripped);
        }
        openFiles.pop();
    }

    private void appendLine(ShaderSource.Line line, String code) {
        Matcher directive = DIRECTIVE.matcher(code);
        String keyword = directive.matches() ? directive.group(1) : "";
        switch (keyword) {
            case "include" -> include(line, directive.group(2));
            case "version" -> version(line, code);
            default -> {
                boolean ascii = code.chars().allMatch(character -> character <= 126);
                require(!keyword.equals("line"), line, "#line is not allowed: files and lines are tracked without it");
                require(ascii, line, "GLSL allows characters beyond ASCII in comments only");
                require(versionSeen || code.isBlank(), line, "#version must come before this line");
                emit(line, code);
            }
        }
    }

    private void include(ShaderSource.Line line, String argument) {
        Matcher quoted = QUOTED_NAME.matcher(argument);
        require(quoted.matches(), line, "#include needs a file name in double quotes");
        require(versionSeen, line, "#version must come before this line");
        String name = withDefines(line, quoted.group(1));
        checkName(name, line.file() + ":" + line.number() + ": #include ");
        List<String> cycle = new ArrayList<>(openFiles);
        Collections.reverse(cycle);
        require(!openFiles.contains(name), line, "cycle of includes: " + String.join(" -> ", cycle) + " -> " + name);
        if (included.add(name)) {
            String content = library.text(name).orElse(null);
            require(content != null, line, "included file " + name + " is missing from the shader library");
            appendFile(name, content);
        } else {
            emit(line, "");
        }
    }

    private String withDefines(ShaderSource.Line line, String name) {
        return DEFINE_IN_NAME.matcher(name).replaceAll(match -> {
            String value = defines.get(match.group(1));
            require(value != null, line, "#include uses the define " + match.group(1) + ", which is not set");
            return Matcher.quoteReplacement(value);
        });
    }

    private void version(ShaderSource.Line line, String code) {
        require(openFiles.size() == 1, line, "#version belongs in the root file " + openFiles.getLast() + " only");
        require(!versionSeen, line, "#version stands here for the second time");
        versionSeen = true;
        emit(line, code);
        int number = 1;
        for (Map.Entry<String, String> define : new TreeMap<>(defines).entrySet()) {
            checkDefine(define.getKey(), define.getValue());
            String text = ("#define " + define.getKey() + " " + define.getValue()).stripTrailing();
            emit(new ShaderSource.Line(PROLOGUE_FILE, number++, text), text);
        }
    }

    private static void checkDefine(String name, String value) {
        // GLSL 3.30, section 3.3: names that begin with GL_ or contain __ are reserved.
        if (!DEFINE.matcher(name).matches() || name.startsWith("GL_") || name.contains("__")) {
            throw new GraphicsException("shader define '" + name + "' is not a valid GLSL macro name");
        }
        boolean oneLineOfAscii = value.chars().allMatch(character -> character >= ' ' && character < 127);
        if (!oneLineOfAscii || value.endsWith("\\")) {
            throw new GraphicsException(
                    "shader define " + name + ": the value '" + value + "' must be one line of plain ASCII");
        }
    }

    private static void checkName(String name, String prefix) {
        if (!SAFE_NAME.matcher(name).matches() || name.matches("(.*/)?\\.\\.?(/.*)?")) {
            throw new GraphicsException(
                    prefix + "\"" + name + "\": a name is relative to the library's root, with forward slashes");
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
