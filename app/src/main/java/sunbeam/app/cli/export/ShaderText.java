package sunbeam.app.cli.export;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Fills in resource files (shaders, pages, notes): a table's numbers replace {@code @NAMES@}. */
final class ShaderText {
    // Schlick's reflectance along the normal, for refractive index 1.5.
    private static final double REFLECTANCE = 0.04;

    private ShaderText() {}

    static String read(String name) {
        return Environment.resource(ShaderText.class, name);
    }

    /** Returns a resource with the numbers of a table; doublings are the mip levels beside the finest. */
    static String of(String name, TableMetadata metadata, int doublings) {
        GridShape shape = metadata.grid().shape();
        ColorTable.Level level = metadata.grid().level();
        double sigma = level.area().window().sigmaOfOrder(ColorTable.MIDDLE_WAVELENGTH);
        Map<String, String> values = new LinkedHashMap<>();
        values.put("PATCH", plain(metadata.setup().patch().name()));
        values.put("LENGTH", Lengths.rounded(metadata.coherenceLength(), 3));
        values.put("ASKED", Lengths.rounded(metadata.requestedCoherenceLength(), 3));
        values.put("WIDTH", Text.format("%.2g", metadata.resolutionDegrees()));
        values.put("LIGHT", plain(metadata.setup().cie().description()));
        values.put("VERSION", Environment.version());
        values.put("ERROR", metadata.error());
        values.put("EXPOSED", Text.format("%.3g", metadata.exposure()));
        values.put("THETA", Text.format("%.3g", metadata.theta()));
        values.put("LAYERS", String.valueOf(shape.depth().count()));
        values.put("U", number(shape.u().first()));
        values.put("V", number(shape.v().first()));
        values.put("STEP", number(shape.u().step()));
        values.put("COLUMNS", number(shape.u().count()));
        values.put("ROWS", number(shape.v().count()));
        values.put("DEPTH", number(shape.depth().first()));
        values.put("DEPTH_STEP", number(shape.depth().step()));
        values.put("SLICES", number(shape.depth().count()));
        values.put("SIGMA", number(sigma));
        values.put("BRDF", number(REFLECTANCE / (2 * Math.PI * sigma * sigma * level.scale())));
        values.put("COARSEST", number(doublings));
        return fill(read(name), values);
    }

    static String fill(String text, Map<String, String> values) {
        String filled = text;
        for (Map.Entry<String, String> value : values.entrySet()) {
            filled = filled.replace("@" + value.getKey() + "@", value.getValue());
        }
        return filled;
    }

    /** Replaces all characters but letters, digits and plain punctuation by "_": a file's name may hold any. */
    private static String plain(String name) {
        return name.replaceAll("[^\\p{L}\\p{N} .,_+-]", "_");
    }

    private static String number(double value) {
        return Text.format("%.9e", value);
    }

    /**
     * A shading language into which sunbeam.glsl is translated, by replacements in its text: the GLSL there uses only what they cover. HLSL and
     * WGSL functions that read the table have it and its sampler as first parameters, because engines differ in how they bind these.
     */
    enum Language {
        GLSL(
                "For GLSL 3.30, 4.x and ES 3.00 (there after \"precision highp float; precision highp sampler2DArray;\")."),
        HLSL(
                "For HLSL of Direct3D 11 and 12, shader model 4 and later.",
                new Rule("uniform sampler2DArray sunbeamTable;\n", ""),
                new Rule("\\bvec([234])\\b", "float$1"),
                new Rule("\\bmat3\\b", "float3x3"),
                new Rule("(?m)^const ", "static const "),
                new Rule("\\batan\\(", "atan2("),
                // A matrix in HLSL lists rows where GLSL lists columns.
                new Rule("SUNBEAM_XYZ_TO_REC709 \\* (.*);", "mul($1, SUNBEAM_XYZ_TO_REC709);"),
                new Rule(
                        "textureLod\\(sunbeamTable, (.*), level\\)",
                        "sunbeamTable.SampleLevel(sunbeamSampler, $1, level)"),
                new Rule(
                        "(?m)^(float3 sunbeam(?:|Xyz|Mean|Power)\\()",
                        "$1Texture2DArray<float4> sunbeamTable, SamplerState sunbeamSampler, "),
                new Rule("\\b(sunbeam(?:|Xyz|Mean|Power)\\()(?!Texture)", "$1sunbeamTable, sunbeamSampler, ")),
        WGSL(
                "For WGSL, of WebGPU.",
                new Rule("uniform sampler2DArray sunbeamTable;\n", ""),
                new Rule("(?m)^const (?:float|vec2|mat3) ", "const "),
                new Rule("\\b(?:int|float|vec[234]) (\\w+)(?= = )", "var $1"),
                new Rule("\\b(float|vec3) (\\w+)(?=[,)])", "$2: $1"),
                new Rule("(?m)^(float|vec3) (sunbeam\\w*)(\\(.*\\)) \\{", "fn $2$3 -> $1 {"),
                new Rule("\\bvec([234])\\b", "vec$1f"),
                new Rule("\\bmat3\\b", "mat3x3f"),
                new Rule("\\bfloat\\b", "f32"),
                new Rule("\\batan\\(", "atan2("),
                new Rule(
                        "textureLod\\(sunbeamTable, vec3f\\((.*), (first .*)\\), level\\)",
                        "textureSampleLevel(sunbeamTable, sunbeamSampler, $1, i32($2), level)"),
                new Rule(
                        "(fn sunbeam(?:|Xyz|Mean|Power)\\()",
                        "$1sunbeamTable: texture_2d_array<f32>, sunbeamSampler: sampler, "),
                new Rule("\\b(sunbeam(?:|Xyz|Mean|Power)\\()(?!sunbeamTable)", "$1sunbeamTable, sunbeamSampler, "));

        private final String title;

        @SuppressWarnings("ImmutableEnumChecker") // an unmodifiable copy
        private final List<Rule> rules;

        Language(String title, Rule... rules) {
            this.title = title;
            this.rules = List.of(rules);
        }

        String ending() {
            return "." + name().toLowerCase(Locale.ROOT);
        }

        String translate(String glsl) {
            String text = glsl.replace("@LANGUAGE@", "// " + title);
            for (Rule rule : rules) {
                text = rule.pattern.matcher(text).replaceAll(rule.replacement);
            }
            return text;
        }

        private record Rule(Pattern pattern, String replacement) {
            Rule(String expression, String replacement) {
                this(Pattern.compile(expression), replacement);
            }
        }
    }
}
