package sunbeam.app.render;

import java.util.List;

/** What is noted of a skin's pixels before they are lit. */
enum GeometryLayout {
    /** All, in single precision (shaders/geometry.frag); with depth 68 bytes a pixel. */
    FULL("geometry.frag", "views", "normals", "tangents", "albedos"),
    /** As much as moving pictures need (shaders/moving_geometry.frag); with depth 20 bytes a pixel. */
    MOVING("moving_geometry.frag", "surfaces");

    private final String shader;

    @SuppressWarnings("ImmutableEnumChecker") // a copy that nobody changes
    private final List<String> samplers;

    GeometryLayout(String shader, String... samplers) {
        this.shader = shader;
        this.samplers = List.of(samplers);
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
