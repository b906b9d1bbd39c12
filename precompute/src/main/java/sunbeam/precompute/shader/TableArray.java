package sunbeam.precompute.shader;

import java.nio.FloatBuffer;
import java.util.function.IntFunction;

/**
 * An array that a shader reads.
 *
 * @param layout its shape
 * @param layers gives a layer by its number, from 0: {@link ArrayLayout#floatsPerLayer()} floats. It may be computed or
 *     read at that moment, so that no more than one layer need be in memory.
 */
public record TableArray(ArrayLayout layout, IntFunction<FloatBuffer> layers) {

    /** An array of one layer, whose floats are there. */
    public static TableArray of(ArrayLayout layout, float[] values) {
        return new TableArray(layout, layer -> FloatBuffer.wrap(values));
    }

    /** An array whose layers are computed when they are asked for. */
    public static TableArray computed(ArrayLayout layout, IntFunction<float[]> layers) {
        return new TableArray(layout, layer -> FloatBuffer.wrap(layers.apply(layer)));
    }

    /** The floats of a layer, from 0 to the buffer's limit. */
    public FloatBuffer layer(int index) {
        return layers.apply(index);
    }
}
