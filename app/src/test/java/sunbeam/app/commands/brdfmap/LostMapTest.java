package sunbeam.app.commands.brdfmap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.map.DiscDirections;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;

/** Light from the normal: the mirror is in the middle of the map. */
final class LostMapTest {
    private static final int SIZE = 33;
    private static final DiscDirections DIRECTIONS = new DiscDirections(SIZE, Direction.ofDegrees(0, 0));
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(65e-6);

    /** A surface's light on all the disc, and the mirror's 1000 times as bright in the middle. */
    private static LinearPicture map(float light) {
        float[] xyz = new float[3 * SIZE * SIZE];
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            int row = pixel / SIZE;
            double x = (pixel % SIZE + 0.5) / SIZE * 2 - 1;
            double y = (row + 0.5) / SIZE * 2 - 1;
            Arrays.fill(xyz, 3 * pixel, 3 * pixel + 3, Math.hypot(x, y) < 0.99 ? light : Float.NaN);
        }
        int middle = SIZE * SIZE / 2;
        Arrays.fill(xyz, 3 * middle, 3 * middle + 3, 1);
        return new LinearPicture(SIZE, SIZE, xyz);
    }

    @Test
    void aMapWhoseLightIsBlackBesideItsMirrorIsLost() {
        assertThat(LostMap.is(map(0.001f), DIRECTIONS, WINDOW, 1)).isTrue();
        assertThat(LostMap.is(map(0.001f), DIRECTIONS, WINDOW, 100)).isFalse();
    }

    @Test
    void ofAMirrorThereIsNothingElseToSee() {
        assertThat(LostMap.is(map(0), DIRECTIONS, WINDOW, 1)).isFalse();
    }
}
