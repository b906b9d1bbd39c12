package sunbeam.precompute.units;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class DecimalsTest {
    @Test
    void roundedNumbersAreNoPowersOfTen() {
        assertThat(Decimals.rounded(100, 2)).isEqualTo("100");
        assertThat(Decimals.rounded(99.96, 2)).isEqualTo("100");
        assertThat(Decimals.rounded(131.4, 2)).isEqualTo("130");
        assertThat(Decimals.rounded(0.0344, 2)).isEqualTo("0.034");
        assertThat(Decimals.rounded(0, 3)).isEqualTo("0");
    }

    /** "1234 to 1234 nm" hid an interval of 0.2 nm. */
    @Test
    void aValueHasTheDigitsThatItsUncertaintyLeaves() {
        assertThat(Decimals.within(1234.04, 0.1)).isEqualTo("1234.04");
        assertThat(Decimals.within(1071, 87)).isEqualTo("1071");
        assertThat(Decimals.within(9252.6, 2850)).isEqualTo("9300");
        assertThat(Decimals.within(2500, 0)).isEqualTo("2500.00");
    }
}
