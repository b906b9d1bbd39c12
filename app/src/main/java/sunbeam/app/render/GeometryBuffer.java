package sunbeam.app.render;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.Texture;

/** Geometry buffer of a block: surface attributes of its pixels. */
record GeometryBuffer(Layout layout, FloatTarget attributes) implements AutoCloseable {
    static GeometryBuffer create(RenderContext context, Layout layout, Tile block) {
        int images = layout.samplers().size();
        return new GeometryBuffer(
                layout,
                context.createFloatTarget(
                        "geometry", new FloatTarget.Spec(block.width(), block.height(), images, true)));
    }

    /** Returns the images by the names of the shading pass's samplers. */
    Map<String, Texture> textures() {
        Map<String, Texture> textures = new HashMap<>();
        for (String sampler : layout.samplers()) {
            textures.put(sampler, attributes.texture(textures.size()));
        }
        return textures;
    }

    /**
     * Reads a part of the full layout's image views: per pixel the direction to the viewer and a fourth value that is 0 without skin
     * (shaders/include/patch_state.glsl). The part's top row comes first.
     */
    float[] views(Tile part) {
        return attributes.read(0, part);
    }

    /**
     * Reads a part of the full layout's image tangents: per pixel the direction of the patch's x axis in world space, and the visible share
     * of the sky. The part's top row comes first.
     */
    float[] tangents(Tile part) {
        return attributes.read(2, part);
    }

    /**
     * Returns the index of a pixel's texel as in shaders/skin.frag: counted row by row from the bottom left. x and y count from the block's
     * top left.
     */
    int texel(int x, int y) {
        int width = attributes.spec().width();
        return (attributes.spec().height() - 1 - y) * width + x;
    }

    @Override
    public void close() {
        attributes.close();
    }

    /** Contents of a geometry buffer. */
    enum Layout {
        /** All attributes in single precision (shaders/geometry.frag); with depth 68 bytes per pixel. */
        FULL("geometry.frag", "views", "normals", "tangents", "albedos"),
        /** Packed attributes for moving pictures (shaders/moving_geometry.frag); with depth 20 bytes per pixel. */
        MOVING("moving_geometry.frag", "surfaces");

        private final String shader;

        @SuppressWarnings("ImmutableEnumChecker") // a private copy
        private final List<String> samplers;

        Layout(String shader, String... samplers) {
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
}
