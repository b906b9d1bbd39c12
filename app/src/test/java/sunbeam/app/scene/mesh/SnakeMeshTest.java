package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SnakeMeshTest {
    private static final Mesh SNAKE = SnakeMesh.create();

    @Test
    void itsSkinIsClosed() {
        MeshChecks.assertClosed(SNAKE);
    }

    @Test
    void itLiesOnTheGround() {
        // A tenth of a millimeter: less than a pixel of any picture of the whole snake.
        assertThat(SkyVisibility.ground(SNAKE)).isBetween(-1e-4, 1e-4);
        assertThat(SnakeBody.length()).isBetween(1.0, 1.2);
    }

    @Test
    void noPartOfTheBodyRunsThroughAnother() {
        int sections = 400;
        for (int i = 0; i <= sections; i++) {
            double place = (double) i / sections;
            Vector3d center = SnakeBody.center(place);
            Vector3d forward = SnakeBody.direction(place);
            Vector3d right = new Vector3d(forward).cross(0, 0, 1).normalize();
            Vector3d up = right.cross(forward, new Vector3d());
            for (int vertex = 0; vertex < SNAKE.vertices(); vertex += 3) {
                double other = SNAKE.textureCoordinates()[2 * vertex];
                Vector3d relative = MeshChecks.position(SNAKE, vertex).sub(center);
                // The neighborhood along the body always touches; a coil's inner side is 0.1 of the body long.
                if (Math.abs(other - SnakeBody.u(place)) > 0.08
                        && Math.abs(relative.dot(forward)) < SnakeBody.length() / sections) {
                    double x = relative.dot(right) / SnakeBody.halfWidth(place);
                    double height = relative.dot(up);
                    double y = height / (height > 0 ? SnakeBody.halfHeight(place) : SnakeBody.bellyDepth(place));
                    // 1 is touching; coils press each other by a few percent, half a millimeter.
                    assertThat(x * x + y * y)
                            .as("skin at %s inside the body at %s", other, place)
                            .isGreaterThan(0.95 * 0.95);
                }
            }
        }
    }
}
