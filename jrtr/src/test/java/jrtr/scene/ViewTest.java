package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import jrtr.Tile;
import jrtr.VertexData;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Views, tiles of a picture, and the sphere about vertices. */
class ViewTest {
    private static final float FIELD = 0.8f;
    private static final Camera CAMERA = new Camera(new Vector3f(0, -5, 0), new Vector3f(), new Vector3f(0, 0, 1));
    private static final View VIEW = new View(CAMERA, FIELD, 0, 0.5f, 20);

    @Test
    void aPartShowsItsPixelsOfTheWhole() {
        View.Area whole = View.Area.whole(400, 300);
        Tile tile = new Tile(100, 30, 50, 60);
        Vector3f point = new Vector3f(-0.6f, 0.3f, -3);
        Vector3f inWhole = VIEW.cameraToClip(whole).transformProject(new Vector3f(point));
        Vector3f inPart = VIEW.cameraToClip(new View.Area(400, 300, tile)).transformProject(new Vector3f(point));

        // Pixels from the left and from the top, in the whole and, shifted by the tile's corner, in the part.
        float column = (inWhole.x + 1) / 2 * 400;
        float row = (1 - inWhole.y) / 2 * 300;
        // Pixel numbers of order 100 in float32, magnified 8 times.
        assertThat((inPart.x + 1) / 2 * 50 + 100).isCloseTo(column, within(1e-3f));
        assertThat((1 - inPart.y) / 2 * 60 + 30).isCloseTo(row, within(1e-3f));
        assertThat(inPart.z).isEqualTo(inWhole.z);
    }

    @Test
    void aNarrowPictureShowsAsMuchFromLeftToRightAsTheLeastAspect() {
        View framed = new View(CAMERA, FIELD, 4f / 3, 0.5f, 20);
        Vector3f right = new Vector3f((float) Math.tan(FIELD / 2) * 4 / 3, 0, -1);
        Vector3f diagonal = new Vector3f(1, 1, -9);

        assertThat(framed.cameraToClip(View.Area.whole(800, 300)))
                .as("wider")
                .isEqualTo(VIEW.cameraToClip(View.Area.whole(800, 300)));
        for (int width : new int[] {399, 300, 3}) {
            Matrix4f narrow = framed.cameraToClip(View.Area.whole(width, 300));
            assertThat(narrow.transformProject(new Vector3f(right)).x).isCloseTo(1, within(1e-6f));
            Vector3f there = narrow.transformProject(new Vector3f(diagonal));
            assertThat(there.x * width).as("pixels are square").isCloseTo(there.y * 300, within(1e-4f));
        }
    }

    @Test
    void camerasWithoutAPictureAreRefused() {
        Vector3f eye = new Vector3f(1, 1, 1);
        Vector3f up = new Vector3f(0, 0, 1);

        assertThatThrownBy(() -> new Camera(eye, eye, up)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(1, 1, 0), up)).hasMessageContaining("line of sight");
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(), new Vector3f()))
                .hasMessageContaining("up");
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(Float.NaN, 0, 0), up))
                .isInstanceOf(IllegalArgumentException.class);
    }

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
    }

    @Test
    void theBoundingSphereJustHoldsTheVertices() {
        float[] positions = {1, 0, 0, 5, 0, 0, 3, 2, 0};
        BoundingSphere bounds =
                new VertexData(positions, new float[9], new float[12], new float[6], new int[] {0, 1, 2}).bounds();
        assertThat(bounds.center()).isEqualTo(new Vector3f(3, 1, 0));
        // Two vertices lie at (2, 1) from the box's middle.
        assertThat(bounds.radius()).isCloseTo((float) Math.sqrt(5), within(1e-6f));
    }
}
