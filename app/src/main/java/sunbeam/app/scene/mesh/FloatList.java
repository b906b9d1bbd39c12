package sunbeam.app.scene.mesh;

import java.util.Arrays;

/** A growing array of floats. */
public final class FloatList {
    private float[] values = new float[64];
    private int size;

    public void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + size / 2);
        }
        values[size++] = (float) value;
    }

    public int size() {
        return size;
    }

    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
