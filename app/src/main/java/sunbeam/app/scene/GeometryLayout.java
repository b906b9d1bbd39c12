package sunbeam.app.scene;

import java.util.List;

/** What is noted of a skin's pixels before they are lit. */
enum GeometryLayout {
    /** All, in single precision (shaders/geometry.frag); with depth 68 bytes a pixel. */
    FULL("geometry.frag"),
    /** As much as moving pictures need (shaders/moving_geometry.frag); with depth 20 bytes a pixel. */
    MOVING("moving_geometry.frag");

    private final String shader;

    GeometryLayout(String shader) {
        this.shader = shader;
    }

    /** The fragment shader that notes it. */
    String shader() {
        return shader;
    }

    /** By which names those that light it know its images, in their order. */
    List<String> samplers() {
        return switch (this) {
            case FULL -> List.of("views", "normals", "tangents", "albedos");
            case MOVING -> List.of("surfaces");
        };
    }
}
