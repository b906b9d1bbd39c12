package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class LinearFileTest {
    // Matrices of sRGB have seven digits.
    private static final float ROUNDING = 1e-5f;

    /** The white of D65, then a pixel without surface. */
    private static final float[] WHITE = {0.95047f, 1, 1.08883f, Float.NaN, Float.NaN, Float.NaN};

    @Test
    void openExrHasWhiteAsOnes() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.exr"), Arrays.copyOf(WHITE, 3), 1, 1).writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        assertThat(bytes.getInt(0)).as("OpenEXR's magic number").isEqualTo(20000630);
        // A line this short is stored uncompressed.
        for (int channel = 1; channel <= 4; channel++) {
            assertThat(bytes.getFloat(bytes.capacity() - channel * Float.BYTES)).isCloseTo(1, within(ROUNDING));
        }
    }

    @Test
    void numPyHasXyzAndNothingAsNaN() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.npy"), WHITE, 2, 1).writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        int at = bytes.capacity() - WHITE.length * Float.BYTES;
        assertThat(bytes.getFloat(at + 8)).isEqualTo(1.08883f);
        assertThat(bytes.getFloat(at + 12)).isNaN();
    }
}
