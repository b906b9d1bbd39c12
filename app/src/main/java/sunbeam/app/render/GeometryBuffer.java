package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/**
 * What a block of a picture shows.
 *
 * @param layout what is noted
 * @param attributes its images, with depth
 */
record GeometryBuffer(GeometryLayout layout, FloatTarget attributes) implements AutoCloseable {
    static GeometryBuffer create(RenderContext context, GeometryLayout layout, Tile block) {
        int images = layout.samplers().size();
        return new GeometryBuffer(
                layout,
                context.createFloatTarget(
                        "geometry", new FloatTargetSpec(block.width(), block.height(), images, true)));
    }

    /** The attributes for those shaders that light them: image i to sampler i. */
    List<Binding> bindings() {
        List<String> samplers = layout.samplers();
        return IntStream.range(0, samplers.size())
                .mapToObj(i -> new Binding(samplers.get(i), attributes.texture(i)))
                .toList();
    }

    /** Of the full layout: directions to the viewer and coverage, 4 values a pixel, the part's top row first. */
    float[] views(Tile part) {
        return attributes.read(0, part);
    }

    /** Of the full layout: along the patch's x and the sky's share, 4 values a pixel, the part's top row first. */
    float[] tangents(Tile part) {
        return attributes.read(2, part);
    }

    /** Number of a pixel's texel as shaders/skin.frag counts them: row by row from the bottom left. */
    int texel(int x, int y) {
        int width = attributes.spec().width();
        return (attributes.spec().height() - 1 - y) * width + x;
    }

    @Override
    public void close() {
        attributes.close();
    }
}
