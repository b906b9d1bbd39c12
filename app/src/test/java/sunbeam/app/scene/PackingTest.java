package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PackingTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 15, 16, 17, 255, 256, 257, 700, 4096, 4097, 5000, 20_000, Packing.MOST - 1, Packing.MOST})
    void everyPixelHasASlotOfItsOwn(int count) {
        Packing packing = new Packing(count);
        assertThat(packing.columns()).isLessThanOrEqualTo(Packing.COLUMNS);
        assertThat(packing.rows()).isLessThanOrEqualTo(Packing.ROWS);
        Set<Integer> taken = new HashSet<>();
        for (int pixel = 0; pixel < count; pixel++) {
            assertThat(packing.column(pixel)).isLessThan(packing.columns());
            assertThat(packing.row(pixel)).isLessThan(packing.rows());
            taken.add(packing.row(pixel) * Packing.COLUMNS + packing.column(pixel));
        }
        assertThat(taken).hasSize(count);
    }

    @Test
    void sixteenNeighborsShareASmallSquare() {
        Packing packing = new Packing(5000);
        for (int pixel = 0; pixel < 5000; pixel++) {
            assertThat(packing.column(pixel) / 4).isEqualTo(packing.column(pixel / 16 * 16) / 4);
            assertThat(packing.row(pixel) / 4).isEqualTo(packing.row(pixel / 16 * 16) / 4);
        }
    }

    @Test
    void fewPixelsAreSpreadOverSeveralProcessorsSquares() {
        assertThat(new Packing(300).columns()).as("two squares of 64 columns").isEqualTo(128);
        assertThat(new Packing(3000).columns()).as("twelve").isEqualTo(768);
    }

    @Test
    void noneAndTooManyAreRefused() {
        assertThatThrownBy(() -> new Packing(0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Packing(Packing.MOST + 1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void coveredPixelsAreFoundOnceAndInSquares() {
        Tile part = new Tile(3, 2, 9, 6);
        float[] views = new float[4 * 9 * 6];
        for (int pixel = 0; pixel < 9 * 6; pixel += 2) {
            views[4 * pixel + 3] = 1;
        }
        int[] covered = PackedShading.covered(views, part);
        assertThat(covered).hasSize(27).doesNotHaveDuplicates();
        assertThat(Arrays.stream(covered)).allMatch(pixel -> pixel % 2 == 0);
        // The first square has columns and rows 0 to 3 of rows of 9.
        assertThat(covered).startsWith(0, 2, 10, 12, 18, 20, 28, 30, 4);
    }
}
