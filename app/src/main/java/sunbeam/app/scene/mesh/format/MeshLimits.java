package sunbeam.app.scene.mesh.format;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import sunbeam.app.files.input.InputException;

/** Limits of mesh files, which readers check before they take memory. */
final class MeshLimits {
    /**
     * Largest number of positions, normals, texture coordinates or triangles. It fits into a heap of 1 GiB and is a hundred times the
     * thesis's snake.
     */
    static final int MOST_ELEMENTS = 2_000_000;

    /** Corners of one face; the time of its triangulation grows with their square. */
    static final int MOST_POLYGON_CORNERS = 1000;

    // 512 MiB.
    private static final long MOST_BYTES = 1L << 29;
    // Largest magnitude of a coordinate; beyond it squared areas leave float32's range.
    private static final double FARTHEST = 1e9;

    private MeshLimits() {}

    static boolean allows(double value) {
        return Math.abs(value) <= FARTHEST;
    }

    static final String BAD_NUMBER = "no finite number up to 1e9; repair the mesh or export it again";

    static void requireSize(Path file) throws IOException {
        long bytes = Files.size(file);
        if (bytes > MOST_BYTES) {
            throw new InputException(
                    file + " has " + bytes + " bytes; at most " + MOST_BYTES + " can be used, so simplify the mesh");
        }
    }
}
