package sunbeam.precompute.units;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class AnglesTest {
    @Test
    void numbersWithoutUnitAreDegrees() {
        assertThat(Angles.parse("180")).isEqualTo(Math.PI);
        assertThat(Angles.parse("-90deg")).isEqualTo(-Math.PI / 2);
        assertThat(Angles.parse("90\u00b0")).isEqualTo(Math.PI / 2);
        assertThat(Angles.parse(" 1.5 rad ")).isEqualTo(1.5);
        assertThat(Angles.parse("4.5e1")).isEqualTo(Math.PI / 4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "deg", "x", "1d", "0x1p3", "NaN", "Infinity", "1e999", "1,5", "30 grad"})
    void anythingElseIsRefusedWithAnExample(String text) {
        assertThatThrownBy(() -> Angles.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining('"' + text + '"')
                .hasMessageContaining("as in 30deg");
    }
}
