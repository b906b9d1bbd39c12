package sunbeam.app.cli.export;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * A shading language into which sunbeam.glsl is translated, by replacements in its text: the GLSL there uses only what they cover. HLSL and
 * WGSL functions that read the table have it and its sampler as first parameters, because engines differ in how they bind these.
 */
enum ShaderLanguage {
    GLSL("For GLSL 3.30, 4.x and ES 3.00 (there after \"precision highp float; precision highp sampler2DArray;\")."),
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
                    "textureLod\\(sunbeamTable, (.*), level\\)", "sunbeamTable.SampleLevel(sunbeamSampler, $1, level)"),
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

    ShaderLanguage(String title, Rule... rules) {
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
