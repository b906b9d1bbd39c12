package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

final class SrgbTest {
    @Test
    void theCurveIsTheStandards() {
        // IEC 61966-2-1: linear 0.2140 is encoded 0.5, and the two pieces meet at 0.0031308; its figures are rounded.
        assertThat(Srgb.encoded(0.2140)).isCloseTo(0.5, within(1e-4));
        assertThat(Srgb.encoded(0.0031308)).isCloseTo(0.04045, within(1e-5));
        assertThat(Srgb.encoded(1)).isCloseTo(1, within(1e-15));
    }

    @Test
    void decodingUndoesEncoding() {
        for (int i = 0; i <= 1000; i++) {
            double encoded = i / 1000.0;
            // The standard's two pieces meet but for a gap of 3e-8.
            assertThat(Srgb.encoded(Srgb.linear(encoded))).isCloseTo(encoded, within(1e-7));
        }
    }

    @Test
    void whiteIsD65() {
        double[] white = Srgb.xyz(Srgb.linearOf(0xffffff));
        // The matrix has seven digits.
        assertThat(white[0]).isCloseTo(0.95047, within(1e-6));
        assertThat(white[1]).isCloseTo(1, within(1e-6));
        assertThat(white[2]).isCloseTo(1.08883, within(1e-6));
    }

    @Test
    void channelsStandInTheirOrder() {
        double[] linear = Srgb.linearOf(0xff8000);
        assertThat(linear[0]).isEqualTo(1);
        assertThat(linear[1]).isCloseTo(0.2159, within(1e-4)); // 128 / 255, by the standard's curve
        assertThat(linear[2]).isZero();
    }
}
