package sunbeam.app.render;

import java.util.List;

/** Contents of a geometry buffer. */
enum GeometryLayout {
    /** All attributes in single precision (shaders/geometry.frag); with depth 68 bytes per pixel. */
    FULL("geometry.frag", "views", "normals", "tangents", "albedos"),
    /** Packed attributes for moving pictures (shaders/moving_geometry.frag); with depth 20 bytes per pixel. */
    MOVING("moving_geometry.frag", "surfaces");

    private final String shader;

    @SuppressWarnings("ImmutableEnumChecker") // a private copy
    private final List<String> samplers;

    GeometryLayout(String shader, String... samplers) {
        this.shader = shader;
        this.samplers = List.of(samplers);
    }

    String shader() {
        return shader;
    }

    List<String> samplers() {
        return samplers;
    }
}
