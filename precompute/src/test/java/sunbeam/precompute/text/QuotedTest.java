package sunbeam.precompute.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class QuotedTest {
    @Test
    void putsTextInQuotes() {
        assertThat(Quoted.of("65 um")).isEqualTo("\"65 um\"");
    }

    @Test
    void replacesControlCharacters() {
        assertThat(Quoted.of("a\nb\r\u001b[1m\u2028c")).isEqualTo("\"a?b??[1m?c\"");
    }

    @Test
    void cutsLongText() {
        assertThat(Quoted.of("x".repeat(61))).isEqualTo("\"" + "x".repeat(60) + "...\"");
        assertThat(Quoted.of("x".repeat(60))).isEqualTo("\"" + "x".repeat(60) + "\"");
    }
}
