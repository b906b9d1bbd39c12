package sunbeam.app.gpu.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import jrtr.Tile;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MapTilesTest {
    @ParameterizedTest
    @CsvSource({"1, 1e-4", "128, 1e-4", "512, 7e-5", "512, 2e-6", "512, 5e-8", "1000, 1e-6", "1000, 3e-8", "2048, 5e-8"
    })
    void partsCoverEachPixelOnceAndAreSoonDone(int size, double secondsPerPixel) {
        List<Tile> parts = new ArrayList<>();
        MapTiles tiles = new MapTiles(size);
        boolean[] covered = new boolean[size * size];
        double known = Double.POSITIVE_INFINITY;
        for (Optional<Tile> tile = tiles.next(known); tile.isPresent(); tile = tiles.next(known)) {
            Tile part = tile.get();
            parts.add(part);
            for (int i = 0; i < part.pixels(); i++) {
                int pixel = (part.y() + i / part.width()) * size + part.x() + i % part.width();
                assertThat(covered[pixel]).isFalse();
                covered[pixel] = true;
            }
            // A tenth of a second, or the least that is drawn at once.
            assertThat(part.pixels() * secondsPerPixel).isLessThanOrEqualTo(Math.max(0.1, 128 * 128 * secondsPerPixel));
            known = secondsPerPixel;
        }
        assertThat(covered).doesNotContain(false);
        if (secondsPerPixel * size * size < 0.1) {
            // One that is not known, the rest of its row, and the rest.
            assertThat(parts).hasSizeLessThanOrEqualTo(3);
        }
    }
}
