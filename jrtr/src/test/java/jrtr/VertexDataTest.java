package jrtr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jrtr.VertexData.BoundingSphere;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

class VertexDataTest {
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
