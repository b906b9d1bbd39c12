package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import jrtr.Tile;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SceneBlocksTest {
    /** 5120 samples need three blocks of at most 2048, whose sides are no multiples of 4 unless they are rounded; 1300 pixels are prime to 4. */
    @ParameterizedTest
    @CsvSource({"1280,720,4", "1300,701,4", "480,270,6", "2060,24,1"})
    void aTileOfPixelsLiesInOneBlock(int width, int height, int side) {
        SceneBlocks blocks = SceneBlocks.of(side * width, side * height, side);
        for (Tile tile : blocks.tiles(side, 128)) {
            Tile samples = new Tile(side * tile.x(), side * tile.y(), side * tile.width(), side * tile.height());
            assertThat(blocks.split(samples)).as("%s", tile).hasSize(1);
        }
    }
}
