package sunbeam.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class ByteSizeTest {
    @ParameterizedTest
    @CsvSource({"0B, 0", "512 B, 512", "1kB, 1000", "1.5GB, 1500000000", "2 gb, 2000000000", "0.5 TB, 500000000000"})
    void unitsAreDecimal(String text, long bytes) {
        assertThat(ByteSize.parse(text)).isEqualTo(bytes);
    }

    @Test
    void invalidSizesAreReportedWithARemedy() {
        for (String wrong :
                new String[] {"", "1", "GB", "-1GB", "1,5GB", "1e3MB", "1 GBit", "1KiB", "2000000TB", "1..5GB"}) {
            assertThatThrownBy(() -> ByteSize.parse(wrong))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContainingAll("'" + wrong + "'", "give");
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0 B", "999, 999 B", "1000, 1.0 kB", "999949, 999.9 kB", "999950, 1.0 MB", "8589934592, 8.6 GB"})
    void isWrittenInTheUnitThatFits(long bytes, String text) {
        assertThat(ByteSize.format(bytes)).isEqualTo(text);
    }
}
