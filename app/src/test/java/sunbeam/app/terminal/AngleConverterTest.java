package sunbeam.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.TypeConversionException;

final class AngleConverterTest {
    private final AngleConverter converter = new AngleConverter();

    @Test
    void numbersAreDegreesUnlessTheySayRadians() {
        assertThat(converter.convert("180")).isEqualTo(Math.PI);
        assertThat(converter.convert("-90deg")).isEqualTo(-Math.PI / 2);
        assertThat(converter.convert(" 1.5 rad ")).isEqualTo(1.5);
        assertThat(converter.convert("4.5e1")).isEqualTo(Math.PI / 4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "deg", "x", "1d", "0x1p3", "NaN", "Infinity", "1e999", "1,5", "30 grad"})
    void anythingElseIsRefusedWithAnExample(String text) {
        assertThatThrownBy(() -> converter.convert(text))
                .isInstanceOf(TypeConversionException.class)
                .hasMessageContaining('"' + text + '"')
                .hasMessageContaining("as in 30deg");
    }
}
