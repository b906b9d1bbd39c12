package jrtr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TileTest {

    @ParameterizedTest
    @CsvSource({"1, 1, 1", "10, 7, 3", "64, 64, 64", "65, 1, 64", "5, 9, 100"})
    void coversEveryPixelExactlyOnce(int width, int height, int side) {
        int[] hits = new int[width * height];
        for (Tile tile : Tile.whole(width, height).divide(side)) {
            assertThat(tile.fitsIn(width, height)).isTrue();
            assertThat(Math.max(tile.width(), tile.height())).isLessThanOrEqualTo(side);
            for (int y = tile.y(); y < tile.y() + tile.height(); y++) {
                for (int x = tile.x(); x < tile.x() + tile.width(); x++) {
                    hits[y * width + x]++;
                }
            }
        }
        assertThat(hits).containsOnly(1);
    }

    @Test
    void refusesEmptyAndNegativeRectangles() {
        assertThat(new Tile(0, 0, 0, 1).fitsIn(4, 4)).isFalse();
        assertThat(new Tile(-1, 0, 1, 1).fitsIn(4, 4)).isFalse();
        assertThatThrownBy(() -> Tile.whole(4, 4).divide(0)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void partsOfATileLieWithinItAndCoverIt() {
        Tile tile = new Tile(5, 7, 10, 9);
        assertThat(tile.divide(4))
                .allMatch(part -> part.x() >= 5 && part.x() + part.width() <= 15)
                .allMatch(part -> part.y() >= 7 && part.y() + part.height() <= 16)
                .hasSize(9)
                .startsWith(new Tile(5, 7, 4, 4));
        assertThat(tile.divide(4).stream().mapToLong(Tile::pixels).sum()).isEqualTo(tile.pixels());
        assertThat(tile.part(new Tile(8, 0, 2, 9))).isEqualTo(new Tile(13, 7, 2, 9));
    }
}
