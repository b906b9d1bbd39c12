package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sparse files as large as a scan, which take next to no disk space. */
class EmptyHeightsTest {
    /** Just more samples than may be equal. */
    private static final int SIDE = 2049;

    @TempDir
    Path folder;

    /** 8-bit gray whose samples were never written. */
    private Path sparse(int columns, int rows) throws IOException {
        Path file = new TinyTiff(columns, rows, 8, new byte[0])
                .with(TinyTiff.STRIP_OFFSETS, 1 << 10)
                .with(TinyTiff.STRIP_BYTES, columns * rows)
                .write(folder.resolve("sparse.tif"));
        try (RandomAccessFile length = new RandomAccessFile(file.toFile(), "rw")) {
            length.setLength((1 << 10) + (long) columns * rows);
        }
        return file;
    }

    private static Patch load(Path file) {
        return PatchRequests.load(file, WIDTH, "100um", MAX_HEIGHT, "1um", LEVEL, "none");
    }

    @Test
    void aLargeFileWithoutAnyHeightIsRefused() throws IOException {
        Path file = sparse(SIDE, SIDE);

        assertThatThrownBy(() -> load(file))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("sparse.tif: all of its 2049 x 2049 samples are equal: it is empty")
                .hasMessageContaining("export the scan again");
    }

    @Test
    void oneSampleThatDiffersIsContent() throws IOException {
        Path file = sparse(SIDE, SIDE);
        try (RandomAccessFile samples = new RandomAccessFile(file.toFile(), "rw")) {
            samples.seek(Files.size(file) - 1);
            samples.write(255);
        }

        assertThat(load(file).heights().relief()).isPositive();
    }
}
