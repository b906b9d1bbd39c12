package sunbeam.precompute.units;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.IntervalWords;

class DecimalsTest {
    @Test
    void roundedNumbersAreNoPowersOfTen() {
        assertThat(Decimals.rounded(100, 2)).isEqualTo("100");
        assertThat(Decimals.rounded(99.96, 2)).isEqualTo("100");
        assertThat(Decimals.rounded(131.4, 2)).isEqualTo("130");
        assertThat(Decimals.rounded(0.0344, 2)).isEqualTo("0.034");
        assertThat(Decimals.rounded(0, 3)).isEqualTo("0");
    }

    /** "1234 to 1234 nm" was an interval of 0.2 nm. */
    @Test
    void anIntervalHasTheDigitsThatItsWidthNeeds() {
        assertThat(IntervalWords.of(1234.04e-9, 1233.95e-9, 1234.15e-9))
                .isEqualTo("1234.04 nm, 95 % interval 1233.95 to 1234.15 nm");
        assertThat(IntervalWords.of(1071e-9, 996.4e-9, 1170.6e-9)).isEqualTo("1071 nm, 95 % interval 996 to 1171 nm");
        assertThat(IntervalWords.of(9252.6e-9, 7701e-9, 13400e-9)).isEqualTo("9300 nm, 95 % interval 7700 to 13400 nm");
        assertThat(IntervalWords.of(5e-6, 4e-6, Double.POSITIVE_INFINITY)).contains("to any length");
        assertThat(IntervalWords.period(2.5e-6, 2.5e-6, 2.5e-6)).isEqualTo("2500.00 nm");
    }
}
