package sunbeam.precompute.scan.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.scan.ScanBytes;

class NumpyReaderTest {
    @TempDir
    Path folder;

    /** The bits of 1, -2, 2^-24 (the smallest), 65504 (the largest), infinity and NaN. */
    private static final short[] HALVES = {0x3c00, (short) 0xc000, 0x0001, 0x7bff, 0x7c00, 0x7e00};

    private Path file(String type, String shape) throws IOException {
        byte[] header = ("{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n")
                .getBytes(StandardCharsets.US_ASCII);
        ByteBuffer file = ByteBuffer.allocate(10 + header.length + 2 * HALVES.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put("\u0093NUMPY\u0001\u0000".getBytes(StandardCharsets.ISO_8859_1))
                .putShort((short) header.length)
                .put(header)
                .order(type.startsWith(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        for (short half : HALVES) {
            file.putShort(half);
        }
        return Files.write(folder.resolve("scan.npy"), file.array());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "f8 | (9999999999, 128) | has 128 x 9999999999 samples; at most",
                "u8 | (2, 3)            | numbers of type u8, which is not read; save a.astype('float64')",
            },
            quoteCharacter = '"')
    void namesTheRemedy(String type, String shape, String complaint) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(file("<" + type, shape))) {
            assertThatThrownBy(() -> NumpyReader.channels(bytes)).hasMessageContaining(complaint);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"<", ">"})
    void readsHalfFloats(String order) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(file(order + "f2", "(2, 3)"))) {
            assertThat(NumpyReader.channels(bytes).get(0).samples().read())
                    .containsExactly(1, -2, Math.pow(2, -24), 65504, Double.POSITIVE_INFINITY, Double.NaN);
        }
    }
}
