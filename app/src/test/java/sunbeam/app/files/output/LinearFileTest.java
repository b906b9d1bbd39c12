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

    /** The red primary of Rec. 709. */
    @Test
    void openExrHasRedAsOne() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.exr"), new float[] {0.4124564f, 0.2126729f, 0.0193339f}, 1, 1)
                .writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        assertThat(bytes.getInt(0)).as("OpenEXR's magic number").isEqualTo(20000630);
        // A line this short is stored uncompressed, its channels in the order of the alphabet.
        float[] stored = new float[4];
        bytes.position(bytes.capacity() - 4 * Float.BYTES)
                .slice()
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(stored);
        assertThat(stored).containsExactly(new float[] {1, 0, 0, 1}, within(ROUNDING));
    }
}
