package sunbeam.app.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.input.InputException;
import sunbeam.app.input.NpyArray;

final class NpyWriterTest {
    @TempDir
    private Path folder;

    @Test
    void theBytesAreThoseOfTheFormat() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        try (NpyWriter writer = new NpyWriter(stream, 1, 2)) {
            writer.append(new float[] {1.5f, Float.NaN}, 0, 2);
        }
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
    void whatIsWrittenInPiecesIsReadAsOneArray() {
        Path target = folder.resolve("out.npy");
        float[] values = new float[3 * 7001 * 2];
        for (int index = 0; index < values.length; index++) {
            values[index] = index;
        }
        AtomicFile.write(target, Overwrite.REFUSE, stream -> {
            try (NpyWriter writer = new NpyWriter(stream, 3, 7001, 2)) {
                writer.append(values, 0, 5);
                writer.append(values, 5, 40_000);
                writer.append(values, 40_005, values.length - 40_005);
            }
        });
        NpyArray array = NpyArray.read(target);
        assertThat(array.shape()).containsExactly(3, 7001, 2);
        assertThat(array.toArray()).isEqualTo(values);
        assertThat(array.at(1, 5, 1)).isEqualTo(7001 * 2 + 5 * 2 + 1);
    }

    @Test
    void anyRankIsPossible() throws IOException {
        assertThat(headerOf()).contains("'shape': ()");
        assertThat(headerOf(1)).contains("'shape': (1,)");
        assertThat(headerOf(1, 1, 1, 1)).contains("'shape': (1, 1, 1, 1)");
    }

    @Test
    void valuesTooManyOrTooFewAreABug() throws IOException {
        NpyWriter writer = new NpyWriter(new ByteArrayOutputStream(), 2);
        assertThatThrownBy(() -> writer.append(new float[3], 0, 3)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(writer::close).isInstanceOf(IllegalStateException.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"(2147483647, 2147483647)", "(3,)", "(99999999999,)", "(4)x"})
    void aHeaderThatPromisesWhatTheFileLacksIsRefused(String shape) throws IOException {
        Path file = folder.resolve("bad.npy");
        NpyWriter.write(file, Overwrite.REFUSE, new float[4], 4);
        byte[] bytes = Files.readAllBytes(file);
        byte[] header = ("{'descr': '<f4', 'fortran_order': False, 'shape': " + shape + ", }" + " ".repeat(40))
                .substring(0, 90)
                .getBytes(StandardCharsets.US_ASCII);
        Arrays.fill(bytes, 10, 128, (byte) ' ');
        System.arraycopy(header, 0, bytes, 10, header.length);
        Files.write(file, bytes);
        assertThatThrownBy(() -> NpyArray.read(file))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(file.toString());
    }

    private static String headerOf(int... shape) throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        try (NpyWriter writer = new NpyWriter(stream, shape)) {
            writer.append(new float[1], 0, 1);
        }
        return stream.toString(StandardCharsets.ISO_8859_1);
    }
}
