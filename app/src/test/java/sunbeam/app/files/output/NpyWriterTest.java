package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

final class NpyWriterTest {
    @Test
    void theBytesAreThoseOfTheFormat() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        NpyWriter.write(stream, new float[] {1.5f, Float.NaN}, 1, 2);
        byte[] bytes = stream.toByteArray();
        assertThat(bytes).startsWith((byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0, 118, 0);
        String header = new String(bytes, 10, 118, StandardCharsets.US_ASCII);
        assertThat(header).matches("\\{'descr': '<f4', 'fortran_order': False, 'shape': \\(1, 2\\), \\} *\n");
        ByteBuffer values = ByteBuffer.wrap(bytes, 128, 8).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(values.getFloat()).isEqualTo(1.5f);
        assertThat(values.getFloat()).isNaN();
        assertThat(bytes).hasSize(136);
    }

    @Test
    void equalArraysMakeEqualArchives() {
        assertThat(NpyWriter.entry("a.npy").getTimeLocal()).isEqualTo(LocalDateTime.of(1980, 1, 1, 0, 0));
    }

    @Test
    void anyNumberOfValuesIsWritten() throws IOException {
        float[] values = new float[3 * 7001 * 2];
        ByteBuffer expected = ByteBuffer.allocate(Float.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int index = 0; index < values.length; index++) {
            values[index] = index;
            expected.putFloat(index);
        }
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        NpyWriter.write(stream, values, 3, 7001, 2);
        assertThat(Arrays.copyOfRange(stream.toByteArray(), 128, stream.size())).isEqualTo(expected.array());
    }
}
