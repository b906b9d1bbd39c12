package sunbeam.precompute.table;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.patch.HeightLevels;

class TableFileTest {
    @TempDir
    Path folder;

    private Path file;
    private FourierTable table;

    @BeforeEach
    void write() {
        HeightLevels heights = HeightLevels.of(Surfaces.random(12, 10, 50e-9, 300e-9, 1));
        PatchIdentity patch = new PatchIdentity("test patch µ", 12, 10, 50e-9, 51e-9, "digest");
        TaylorExpansion expansion = new TaylorExpansion(HeightScale.mean(heights), 4, 5);
        table = new TableBuilder(patch, heights, done -> {}).build(expansion, Band.of(-2, 3), Band.of(-4, 1));
        file = folder.resolve("table.h5");
        TableFile.write(file, table);
    }

    @Test
    void everythingComesBackToTheLastBit() {
        FourierTable read = TableFile.read(file);
        assertThat(read.patch()).isEqualTo(table.patch());
        assertThat(read.kind()).isEqualTo(table.kind());
        assertThat(read.scale()).isEqualTo(table.scale());
        assertThat(read.bandX()).isEqualTo(table.bandX());
        assertThat(read.bandY()).isEqualTo(table.bandY());
        assertThat(read.coefficients()).isEmpty();
        assertThat(Arrays.deepEquals(read.real(), table.real())).isTrue();
        assertThat(Arrays.deepEquals(read.imaginary(), table.imaginary())).isTrue();
    }

    @Test
    void aMissingFileIsNamed() {
        assertThatThrownBy(() -> TableFile.read(folder.resolve("none.h5")))
                .isInstanceOf(TableException.class)
                .hasMessageContaining("none.h5")
                .hasMessageContaining("precompute");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.02, 0.3, 0.7, 0.999})
    void aTruncatedFileIsRefused(double share) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(bytes, (int) (share * bytes.length)));
        assertThatThrownBy(() -> TableFile.read(file))
                .isInstanceOf(TableException.class)
                .hasMessageContaining("table.h5");
    }

    @Test
    void anyFlippedBitOfTheDataIsNoticed() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        byte[] needle = new byte[8];
        ByteBuffer.wrap(needle)
                .order(ByteOrder.nativeOrder())
                .putFloat(table.real()[1][7])
                .putFloat(table.real()[1][8]);
        int at = indexOf(bytes, needle);
        for (int bit = 0; bit < 32; bit++) {
            byte[] damaged = bytes.clone();
            damaged[at + bit / 8] ^= (byte) (1 << bit % 8);
            Files.write(file, damaged);
            assertThatThrownBy(() -> TableFile.read(file))
                    .as("bit %d", bit)
                    .isInstanceOf(TableException.class)
                    .hasMessageContaining("checksum");
        }
    }

    /** Lengths are numbers in the file, too: one bit more of them must not take all of the memory. */
    @Test
    void anyFlippedBitIsNoticedOrHarmless() throws IOException {
        byte[] good = Files.readAllBytes(file);
        Random random = new Random(1);
        for (int flip = 0; flip < 1500; flip++) {
            byte[] bad = good.clone();
            bad[random.nextInt(bad.length)] ^= (byte) (1 << random.nextInt(8));
            Files.write(file, bad);
            try {
                assertThat(TableFile.read(file).real()).isDeepEqualTo(table.real());
            } catch (TableException noticed) {
                assertThat(noticed).hasMessageContaining("table.h5");
            }
        }
    }

    @Test
    void anAlteredAttributeIsNoticed() throws IOException {
        replace("test patch", "fest patch");
        // HDF5's own checksum of attributes notices it first.
        assertThatThrownBy(() -> TableFile.read(file)).hasMessageContainingAll("table.h5", "hecksum");
    }

    @Test
    void anyFileThatIsNoTableIsRefused() throws IOException {
        Files.writeString(file, "not HDF5 at all, but long enough to hold a superblock ".repeat(20));
        assertThatThrownBy(() -> TableFile.read(file)).isInstanceOf(TableException.class);
    }

    @Test
    void anotherFormatIsRefused() throws IOException {
        Files.delete(file);
        try (WritableHdfFile hdf = HdfFile.write(file)) {
            hdf.putDataset("terms", new float[1][2][3][4]);
            hdf.putAttribute("format", "something else");
        }
        assertThatThrownBy(() -> TableFile.read(file)).hasMessageContaining("not a Sunbeam table");
    }

    @Test
    void aTableOfAnotherVersionIsRefusedWithBothVersions() {
        Path later = folder.resolve("later.h5");
        try (WritableHdfFile hdf = HdfFile.write(later)) {
            hdf.putDataset("terms", new float[1][2][3][4]);
            hdf.putAttribute("format", TableAttributes.FORMAT);
            hdf.putAttribute("format_version", 99);
        }
        assertThatThrownBy(() -> TableFile.read(later))
                .isInstanceOf(TableException.class)
                .hasMessageContaining("version 99")
                .hasMessageContaining("version " + TableAttributes.VERSION);
    }

    private void replace(String text, String by) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        byte[] replacement = by.getBytes(StandardCharsets.UTF_8);
        int at = indexOf(bytes, text.getBytes(StandardCharsets.UTF_8));
        System.arraycopy(replacement, 0, bytes, at, replacement.length);
        Files.write(file, bytes);
    }

    private static int indexOf(byte[] bytes, byte[] needle) {
        for (int at = 0; at + needle.length <= bytes.length; at++) {
            if (Arrays.equals(Arrays.copyOfRange(bytes, at, at + needle.length), needle)) {
                return at;
            }
        }
        throw new AssertionError("the file does not contain what the test looks for");
    }
}
