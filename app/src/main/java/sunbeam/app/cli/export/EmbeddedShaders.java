package sunbeam.app.cli.export;

import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import jrtr.glsl.ShaderLibrary;
import sunbeam.app.gpu.Shaders;

/** Shaders of page.html: its own (disc.glsl, skin.glsl, samples.glsl) and those of pictures, translated to GLSL ES 3.00. */
final class EmbeddedShaders {
    private static final Map<String, String> OF_PICTURES = Map.of(
            "fullscreen.vert", "jrtr/fullscreen.vert.glsl",
            "mesh.vert", "jrtr/mesh.vert.glsl",
            "ground", "ground.frag",
            "shadow", "shadow.frag");
    private static final String VERSION = "#version 330 core\n";
    private static final String ES = """
            #version 300 es
            precision highp float;
            precision highp int;
            precision highp sampler2D;
            precision highp sampler2DArray;
            """;
    // Initial values of uniforms, which GLSL ES has not; the page sets all.
    private static final Pattern INITIAL = Pattern.compile("(?m)^(uniform [^=;]*?) = [^;]*;");
    private static final Pattern BLANK_LINES = Pattern.compile("\n(?:[ ]*\n)+");

    private EmbeddedShaders() {}

    /** @param table text of sunbeam.glsl with a table's numbers */
    static String text(String name, String table) {
        ShaderLibrary own = file -> switch (file) {
            case "sunbeam.glsl" -> Optional.of(table);
            case "disc", "skin", "samples" -> Optional.of(ShaderText.read(file + ".glsl"));
            default -> Optional.empty();
        };
        String source = own.orElse(Shaders.library())
                .load(OF_PICTURES.getOrDefault(name, name), Map.of("SCREEN", "1"))
                .text()
                .replace(VERSION, ES);
        return BLANK_LINES.matcher(INITIAL.matcher(source).replaceAll("$1;")).replaceAll("\n");
    }
}
