package sunbeam.app.scene;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.Binding;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.RenderContext;
import jrtr.Tile;

/**
 * What a block of a picture shows (shaders/geometry.frag); 68 bytes a pixel.
 *
 * @param attributes four images with depth
 */
record GeometryBuffer(FloatTarget attributes) implements AutoCloseable {
    private static final List<String> SAMPLERS = List.of("views", "normals", "tangents", "albedos");

    static GeometryBuffer create(RenderContext context, Tile block) {
        return new GeometryBuffer(context.createFloatTarget(
                "geometry", new FloatTargetSpec(block.width(), block.height(), SAMPLERS.size(), true)));
    }

    /** The attributes for shaders/skin.frag: image i to sampler i. */
    List<Binding> bindings() {
        return IntStream.range(0, SAMPLERS.size())
                .mapToObj(i -> new Binding(SAMPLERS.get(i), attributes.texture(i)))
                .toList();
    }

    /** Directions to the viewer and coverage, 4 values a pixel, the part's top row first. */
    float[] views(Tile part) {
        return attributes.read(0, part);
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
