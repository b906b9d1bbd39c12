package sunbeam.precompute.plan;

import java.nio.FloatBuffer;
import java.util.function.IntFunction;

/** Array that a shader reads. Layers, of {@link ArrayLayout#floatsPerLayer()} floats, may be computed when read, to save memory. */
public record TableArray(ArrayLayout layout, IntFunction<FloatBuffer> layers) {
    public static TableArray of(ArrayLayout layout, float[] values) {
        return new TableArray(layout, layer -> FloatBuffer.wrap(values));
    }

    public static TableArray computed(ArrayLayout layout, IntFunction<float[]> layers) {
        return new TableArray(layout, layer -> FloatBuffer.wrap(layers.apply(layer)));
    }

    /** Returns a layer's floats, from index 0 to the buffer's limit. */
    public FloatBuffer layer(int index) {
        return layers.apply(index);
    }
}
