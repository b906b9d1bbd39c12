package sunbeam.app.scene;

import java.util.List;

/** What is noted of a skin's pixels before they are lit. */
enum GeometryLayout {
    /** All, in single precision (shaders/geometry.frag); with depth 68 bytes a pixel. */
    FULL("geometry.frag", List.of("views", "normals", "tangents", "albedos")),
    /** As much as moving pictures need (shaders/moving_geometry.frag); with depth 20 bytes a pixel. */
    MOVING("moving_geometry.frag", List.of("surfaces"));

    private final String shader;
    private final List<String> samplers;

    GeometryLayout(String shader, List<String> samplers) {
        this.shader = shader;
        this.samplers = samplers;
    }

    /** The fragment shader that notes it. */
    String shader() {
        return shader;
    }

    /** By which names those that light it know its images, in their order. */
    List<String> samplers() {
        return samplers;
    }
}
