package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class NumberFormatTest {
    /** By the standard's definition. */
    static double value(short half) {
        int exponent = (half >> 10) & 0x1f;
        int fraction = half & 0x3ff;
        double magnitude =
                exponent == 0 ? Math.scalb((double) fraction, -24) : Math.scalb(1024.0 + fraction, exponent - 25);
        return half < 0 ? -magnitude : magnitude;
    }

    /** Coefficients as the shader takes them. */
    static float[] decoded(byte[] tile, NumberFormat numbers) {
        ByteBuffer bytes = ByteBuffer.wrap(tile).order(ByteOrder.nativeOrder());
        float[] values = new float[tile.length / numbers.bytes()];
        for (int i = 0; i < values.length; i++) {
            values[i] = numbers == NumberFormat.FLOAT
                    ? bytes.getFloat(Float.BYTES * i)
                    : (float) (value(bytes.getShort(Short.BYTES * i)) / numbers.scale());
        }
        return values;
    }

    @Test
    void roundsToTheNearestHalfAndTiesToEven() {
        SplittableRandom random = new SplittableRandom(3);
        for (int bits = 0; bits < 0x7bff; bits++) {
            double low = value((short) bits);
            double high = value((short) (bits + 1));
            assertThat(NumberFormat.half((float) low)).isEqualTo((short) bits);
            float middle = (float) (0.5 * (low + high));
            assertThat(NumberFormat.half(middle)).isEqualTo((short) (bits + (bits & 1)));
            assertThat(NumberFormat.half(Math.nextDown(middle))).isEqualTo((short) bits);
            assertThat(NumberFormat.half(Math.nextUp(middle))).isEqualTo((short) (bits + 1));
            float some = (float) (low + (high - low) * random.nextDouble(0.51, 1));
            assertThat(NumberFormat.half(-some)).isEqualTo((short) (0x8000 | (bits + 1)));
        }
    }

    @Test
    void largerNumbersBecomeTheLargestHalf() {
        for (float large : new float[] {65504, 65519, 65520, 1e6f, Float.MAX_VALUE, Float.POSITIVE_INFINITY}) {
            assertThat(value(NumberFormat.half(large))).isEqualTo(65504);
            assertThat(value(NumberFormat.half(-large))).isEqualTo(-65504);
        }
    }

    @Test
    void rootsOfPowersFarBelowAMirrorsKeepElevenBits() {
        for (double power = 1; power > 4e-14; power *= 0.37) {
            float root = (float) Math.sqrt(power);
            float[] kept = decoded(NumberFormat.HALF.encoded(new float[] {root, -root}), NumberFormat.HALF);
            assertThat(Math.abs(kept[0] / root - 1)).isLessThanOrEqualTo(0x1p-11f);
            assertThat(kept[1]).isEqualTo(-kept[0]);
        }
    }
}
