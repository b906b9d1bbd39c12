package jrtr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import jrtr.VertexData.BoundingSphere;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tiles of a picture, and arrays of vertices. */
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

    private static VertexData triangle(float[] positions, int... indices) {
        int vertices = positions.length / 3;
        return new VertexData(
                positions, new float[3 * vertices], new float[4 * vertices], new float[2 * vertices], indices);
    }

    @Test
    void theBoundingSphereJustHoldsTheVertices() {
        BoundingSphere bounds =
                triangle(new float[] {1, 0, 0, 5, 0, 0, 3, 2, 0}, 0, 1, 2).bounds();

        assertThat(bounds.center()).isEqualTo(new Vector3f(3, 1, 0));
        // Two vertices lie at (2, 1) from the box's middle.
        assertThat(bounds.radius()).isCloseTo((float) Math.sqrt(5), within(1e-6f));
    }
}
