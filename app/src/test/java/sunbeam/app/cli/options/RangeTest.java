package sunbeam.app.cli.options;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.TypeConversionException;

final class RangeTest {
    private final Range.Converter converter = new Range.Converter();

    @Test
    void holdsBothEnds() {
        Range range = converter.convert("380:780:5");
        assertThat(range.count()).isEqualTo(81);
        assertThat(range.values()).startsWith(380, 385).endsWith(780);
    }

    @Test
    void roundingOfTheStepLosesNoEnd() {
        assertThat(converter.convert("0:0.3:0.1").values()).hasSize(4).endsWith(0.3);
    }

    @Test
    void stopsBelowAnEndThatTheStepDoesNotMeet() {
        assertThat(converter.convert("0:10:4").values()).containsExactly(0, 4, 8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"550:550:1", "550"})
    void oneValueIsARange(String text) {
        assertThat(converter.convert(text).values()).containsExactly(550);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1:2", "1:2:3:4", "a:2:1", "2:1:1", "1:2:0", "1:2:-1", "1:NaN:1", "0:1e9:1e-9"})
    void anythingElseIsRefused(String text) {
        assertThatThrownBy(() -> converter.convert(text))
                .isInstanceOf(TypeConversionException.class)
                .hasMessageStartingWith("'" + text + "' is not a range");
    }
}
