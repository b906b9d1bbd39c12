package jrtr.glsl;

import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import jrtr.ShaderSource;

/** Finds which uniforms a shader's text declares, whether or not the compiler keeps them. */
public final class DeclaredUniforms {
    private static final Pattern DECLARATION = Pattern.compile("\\buniform\\b([^;{}]*);");
    private static final Pattern BRACKETS = Pattern.compile("\\[[^\\]]*\\]");
    private static final Pattern LAST_WORD = Pattern.compile("(\\w+)\\s*$");

    private DeclaredUniforms() {}

    /** Names in {@code uniform type a, b[3] = ...;} declarations, also those behind an {@code #if}; sorted. */
    public static Set<String> in(ShaderSource source) {
        Set<String> names = new TreeSet<>();
        Matcher declarations = DECLARATION.matcher(source.text());
        while (declarations.find()) {
            String declared = BRACKETS.matcher(declarations.group(1)).replaceAll("");
            for (String declarator : withoutInitialValues(declared).split(",", -1)) {
                Matcher name = LAST_WORD.matcher(declarator);
                if (name.find()) {
                    names.add(name.group(1));
                }
            }
        }
        return names;
    }

    /** Drops {@code = value}, whose parentheses may hold commas. */
    private static String withoutInitialValues(String declared) {
        StringBuilder kept = new StringBuilder();
        int depth = 0;
        boolean insideValue = false;
        for (int index = 0; index < declared.length(); index++) {
            char character = declared.charAt(index);
            depth += character == '(' ? 1 : character == ')' ? -1 : 0;
            insideValue = character == '=' || (insideValue && !(character == ',' && depth == 0));
            if (!insideValue) {
                kept.append(character);
            }
        }
        return kept.toString();
    }
}
