package jrtr.glsl;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import jrtr.ShaderException;

/** The prologue of {@code #define NAME value} lines. */
final class Defines {
    private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

    private Defines() {}

    /** One line per define, sorted by name. */
    static List<String> prologue(Map<String, String> defines) {
        List<String> lines = new ArrayList<>();
        new TreeMap<>(defines).forEach((name, value) -> {
            check(name, value);
            lines.add(("#define " + name + " " + value).stripTrailing());
        });
        return lines;
    }

    private static void check(String name, String value) {
        // GLSL 3.30, section 3.3: names with GL_ in front or __ anywhere are the language's own.
        if (!NAME.matcher(name).matches() || name.startsWith("GL_") || name.contains("__")) {
            throw new ShaderException("shader define '" + name + "' is no name that GLSL allows for a macro");
        }
        boolean oneLineOfAscii = value.chars().allMatch(character -> character >= ' ' && character < 127);
        if (!oneLineOfAscii || value.endsWith("\\")) {
            throw new ShaderException(
                    "shader define " + name + ": the value '" + value + "' must be one line of plain ASCII");
        }
    }
}
