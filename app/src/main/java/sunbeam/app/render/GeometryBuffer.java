package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/**
 * Geometry buffer of a block: surface attributes of its pixels.
 *
 * @param layout images and their contents
 * @param attributes images, with depth
 */
record GeometryBuffer(GeometryLayout layout, FloatTarget attributes) implements AutoCloseable {
    static GeometryBuffer create(RenderContext context, GeometryLayout layout, Tile block) {
        int images = layout.samplers().size();
        return new GeometryBuffer(
                layout,
                context.createFloatTarget(
                        "geometry", new FloatTargetSpec(block.width(), block.height(), images, true)));
    }

    /** Returns the attributes' bindings for the shading pass: image i to sampler i. */
    List<Binding> bindings() {
        List<String> samplers = layout.samplers();
        return IntStream.range(0, samplers.size())
                .mapToObj(i -> new Binding(samplers.get(i), attributes.texture(i)))
                .toList();
    }

    /** Reads, from the full layout, directions to the viewer and coverage, 4 values per pixel, the part's top row first. */
    float[] views(Tile part) {
        return attributes.read(0, part);
    }

    /**
     * Reads, from the full layout, directions of the patch's x axis and visible shares of the sky, 4 values per pixel, the part's top row
     * first.
     */
    float[] tangents(Tile part) {
        return attributes.read(2, part);
    }

    /** Returns the index of a pixel's texel in shaders/skin.frag, row by row from the bottom left. */
    int texel(int x, int y) {
        int width = attributes.spec().width();
        return (attributes.spec().height() - 1 - y) * width + x;
    }

    @Override
    public void close() {
        attributes.close();
    }
}
