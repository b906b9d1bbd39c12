package sunbeam.app.scene;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.Binding;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.RenderContext;
import jrtr.Tile;

/**
 * What a block of a picture shows (shaders/geometry.frag), and room for its light; 84 bytes a pixel.
 *
 * @param attributes four images with depth, drawn from triangles
 * @param radiance linear XYZ and coverage, drawn from the attributes
 */
record GeometryBuffer(FloatTarget attributes, FloatTarget radiance) implements AutoCloseable {
    private static final List<String> SAMPLERS = List.of("views", "normals", "tangents", "albedos");

    static GeometryBuffer create(RenderContext context, Tile block) {
        FloatTarget attributes = context.createFloatTarget(
                "geometry", new FloatTargetSpec(block.width(), block.height(), SAMPLERS.size(), true));
        try {
            return new GeometryBuffer(
                    attributes,
                    context.createFloatTarget("radiance", FloatTargetSpec.color(block.width(), block.height())));
        } catch (RuntimeException failure) {
            attributes.close();
            throw failure;
        }
    }

    /** The attributes for shaders/skin.frag: image i to sampler i. */
    List<Binding> bindings() {
        return IntStream.range(0, SAMPLERS.size())
                .mapToObj(i -> new Binding(SAMPLERS.get(i), attributes.texture(i)))
                .toList();
    }

    @Override
    public void close() {
        attributes.close();
        radiance.close();
    }
}
