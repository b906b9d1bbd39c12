package sunbeam.app.scene.mesh;

import java.util.Arrays;

/**
 * Numbers vertices from 0 in the order in which they are first met; a vertex is four whole numbers. Hashing with linear
 * probing, so that any number of vertices may share a position.
 */
final class VertexNumbers {
    private static final int PARTS = 4;
    private static final int FREE = -1;
    private static final int FIRST_CAPACITY = 1 << 10;

    /** Number of the vertex in each place of the table, or {@link #FREE}. */
    private int[] places = free(FIRST_CAPACITY);

    private int[] parts = new int[PARTS * FIRST_CAPACITY];
    private int count;

    private static int[] free(int capacity) {
        int[] places = new int[capacity];
        Arrays.fill(places, FREE);
        return places;
    }

    /** The number of a vertex: the count of those met before where it is new. */
    int of(int position, int textureCoordinate, int normal, int handedness) {
        int place = place(position, textureCoordinate, normal, handedness);
        if (places[place] != FREE) {
            return places[place];
        }
        if (PARTS * count == parts.length) {
            parts = Arrays.copyOf(parts, 2 * parts.length);
        }
        int at = PARTS * count;
        parts[at] = position;
        parts[at + 1] = textureCoordinate;
        parts[at + 2] = normal;
        parts[at + 3] = handedness;
        places[place] = count;
        count++;
        if (2 * count > places.length) {
            grow();
        }
        return count - 1;
    }

    private void grow() {
        places = free(2 * places.length);
        for (int vertex = 0; vertex < count; vertex++) {
            int at = PARTS * vertex;
            places[place(parts[at], parts[at + 1], parts[at + 2], parts[at + 3])] = vertex;
        }
    }

    /** Where the vertex is, or where it belongs. */
    private int place(int position, int textureCoordinate, int normal, int handedness) {
        int mask = places.length - 1;
        int place = mixed(position, textureCoordinate, normal, handedness) & mask;
        while (places[place] != FREE && !isAt(places[place], position, textureCoordinate, normal, handedness)) {
            place = (place + 1) & mask;
        }
        return place;
    }

    private boolean isAt(int vertex, int position, int textureCoordinate, int normal, int handedness) {
        int at = PARTS * vertex;
        return parts[at] == position
                && parts[at + 1] == textureCoordinate
                && parts[at + 2] == normal
                && parts[at + 3] == handedness;
    }

    /** Each part by an odd factor of its own, then the finaliser of MurmurHash3, which spreads neighbors. */
    private static int mixed(int position, int textureCoordinate, int normal, int handedness) {
        int hash = position * 0x9e3779b1 + textureCoordinate * 0x85ebca77 + normal * 0xc2b2ae3d + handedness;
        hash = (hash ^ (hash >>> 16)) * 0x85ebca6b;
        hash = (hash ^ (hash >>> 13)) * 0xc2b2ae35;
        return hash ^ (hash >>> 16);
    }
}
