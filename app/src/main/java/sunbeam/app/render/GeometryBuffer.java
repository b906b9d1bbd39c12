package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/** Geometry buffer of a block: surface attributes of its pixels. */
record GeometryBuffer(GeometryLayout layout, FloatTarget attributes) implements AutoCloseable {
    static GeometryBuffer create(RenderContext context, GeometryLayout layout, Tile block) {
        int images = layout.samplers().size();
        return new GeometryBuffer(
                layout,
                context.createFloatTarget(
                        "geometry", new FloatTargetSpec(block.width(), block.height(), images, true)));
    }

    /** Binds image i to sampler i of the shading pass. */
    List<Binding> bindings() {
        List<String> samplers = layout.samplers();
        return IntStream.range(0, samplers.size())
                .mapToObj(i -> new Binding(samplers.get(i), attributes.texture(i)))
                .toList();
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
}
