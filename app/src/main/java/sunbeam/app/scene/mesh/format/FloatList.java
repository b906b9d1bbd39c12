package sunbeam.app.scene.mesh.format;

import java.util.Arrays;
import org.joml.Vector3d;

/** A growing array of floats. */
public final class FloatList {
    private float[] values = new float[64];
    private int size;

    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + size / 2);
        }
        values[size++] = value;
    }

    public Vector3d vector(int index) {
        return new Vector3d(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    }

    public int size() {
        return size;
    }

    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
