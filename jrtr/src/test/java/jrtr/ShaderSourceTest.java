package jrtr;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import jrtr.glsl.ShaderTexts;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShaderSourceTest {
    /** Expanded line 4 is line 2 of lens.glsl. */
    private final ShaderSource source = ShaderTexts.of(Map.of(
                    "root.glsl", "#version 330 core\nfloat a;\n#include \"lens.glsl\"\n",
                    "lens.glsl", "float b;\n    float c = foo; // why\n"))
            .load("root.glsl");

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "0:4(13): error: `foo' undeclared | lens.glsl:2: `foo' undeclared: `float c = foo; // why` [doing]",
                "0:4(1): preprocessor error: syntax error | lens.glsl:2: syntax error: `float c = foo; // why` [doing]",
                "0(4) : error C1503: undefined | lens.glsl:2: C1503: undefined: `float c = foo; // why` [doing]",
                "0(4) : fatal error C9999: gone | lens.glsl:2: C9999: gone: `float c = foo; // why` [doing]",
                "ERROR: 0:4: 'foo' : undeclared | lens.glsl:2: 'foo' : undeclared: `float c = foo; // why` [doing]",
                // A line past the end is the last one.
                "0:99(1): error: end of file | lens.glsl:2: end of file: `float c = foo; // why` [doing]",
                "0:99999999999(1): error: end | lens.glsl:2: end: `float c = foo; // why` [doing]",
                // Messages without a line count only if none has a line; warnings do not count.
                "error: no main | root.glsl: error: no main [doing]",
                "Fragment info;0(2) : error C1: x | root.glsl:2: C1: x: `float a;` [doing]",
                "0:4(3): warning: unused | root.glsl: the driver failed without a reason [doing]",
                "0:2(1): warning: odd;0:2(3): error: a;0:4(1): error: b | root.glsl:2: a: `float a;` [doing, and 1 more]"
            })
    void theMessageOfEveryDriverNamesTheAuthorsLine(String log, String message) {
        assertThat(source.failure("doing", log.replace(";", "\n") + "\n\0"))
                .hasMessage(message);
    }
}
