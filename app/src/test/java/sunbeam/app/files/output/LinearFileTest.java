package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class LinearFileTest {
    // Matrices of sRGB have seven digits.
    private static final float ROUNDING = 1e-5f;

    /** The white of D65. */
    @Test
    void openExrHasWhiteAsOnes() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.exr"), new float[] {0.95047f, 1, 1.08883f}, 1, 1)
                .writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        assertThat(bytes.getInt(0)).as("OpenEXR's magic number").isEqualTo(20000630);
        // A line this short is stored uncompressed.
        for (int channel = 1; channel <= 4; channel++) {
            assertThat(bytes.getFloat(bytes.capacity() - channel * Float.BYTES)).isCloseTo(1, within(ROUNDING));
        }
    }
}
