package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import jrtr.ShaderException;
import jrtr.ShaderProblem;
import jrtr.ShaderSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CompilerLogTest {
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
                "0:4(13): error: `foo' undeclared | `foo' undeclared",
                "0:4(1): preprocessor error: syntax error | syntax error",
                "0(4) : error C1503: undefined variable \"foo\" | C1503: undefined variable \"foo\"",
                "0(4) : fatal error C9999: gone | C9999: gone",
                "ERROR: 0:4: 'foo' : undeclared identifier | 'foo' : undeclared identifier"
            })
    void everyDriversFormIsPutAtTheAuthorsLine(String log, String message) {
        List<ShaderProblem> problems = CompilerLog.parse(log + "\n\0", source);

        assertThat(problems).containsExactly(new ShaderProblem("lens.glsl", 2, message, "    float c = foo; // why"));
    }

    @Test
    void messagesWithoutALineCountOnlyIfNoneHasALine() {
        assertThat(CompilerLog.parse("error: no main\n", source))
                .containsExactly(new ShaderProblem("root.glsl", 0, "error: no main", ""));
        assertThat(CompilerLog.parse("Fragment info\n-----\n0(2) : error C1: x\n", source))
                .extracting(ShaderProblem::line)
                .containsExactly(2);
        assertThat(CompilerLog.parse("\n0:4(3): warning: `foo' used uninitialized\n\0", source))
                .isEmpty();
    }

    @Test
    void aLinePastTheEndIsTheLastOne() {
        assertThat(CompilerLog.parse("0:99(1): error: end of file\n0:99999999999(1): error: end", source))
                .allSatisfy(
                        problem -> assertThat(problem.file() + problem.line()).isEqualTo("lens.glsl2"));
    }

    @Test
    void theExceptionSaysFileLineMessageAndTheOffendingLineOnOneLine() {
        List<ShaderProblem> problems = CompilerLog.parse(
                "0:2(1): warning: odd\n0:4(13): error: `foo' undeclared\n0:4(1): error: more\n", source);

        assertThat(new ShaderException("compiling root.glsl", problems))
                .hasMessage("lens.glsl:2: `foo' undeclared: `float c = foo; // why` "
                        + "[compiling root.glsl, and 1 more]");
    }
}
