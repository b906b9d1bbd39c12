package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.Overwrite;

/**
 * The largest mesh that is read, a hilly square of 2 million triangles without normals and texture coordinates, read,
 * completed and written in 10 s. Not among the tests: {@code ./sunbeam test -Dtest=LargeMeshRun}.
 */
final class LargeMeshRun {
    private static final int SIDE = 1000;
    private static final double MOST_SECONDS = 10;

    @TempDir
    private Path folder;

    private Path grid() throws IOException {
        Path file = folder.resolve("grid.obj");
        try (BufferedWriter writer = Files.newBufferedWriter(file)) {
            for (int row = 0; row <= SIDE; row++) {
                for (int column = 0; column <= SIDE; column++) {
                    double height = 1e-3 * Math.sin(0.05 * column) * Math.cos(0.03 * row);
                    writer.write(String.format(Locale.ROOT, "v %.6f %.6f %.6f%n", 1e-4 * column, 1e-4 * row, height));
                }
            }
            for (int row = 0; row < SIDE; row++) {
                for (int column = 1; column <= SIDE; column++) {
                    int below = row * (SIDE + 1) + column;
                    int above = below + SIDE + 1;
                    writer.write("f " + below + " " + (below + 1) + " " + (above + 1) + "\n");
                    writer.write("f " + below + " " + (above + 1) + " " + above + "\n");
                }
            }
        }
        return file;
    }

    @Test
    void twoMillionTrianglesTakeTenSeconds() throws IOException {
        Path file = grid();
        long start = System.nanoTime();
        Mesh mesh = MeshReader.read(file).mesh();
        double read = (System.nanoTime() - start) * 1e-9;
        MeshWriter.write(folder.resolve("out.obj"), Overwrite.REFUSE, mesh);
        double all = (System.nanoTime() - start) * 1e-9;
        System.out.printf(
                Locale.ROOT, "%d triangles: read in %.1f s, written in %.1f s%n", mesh.triangles(), read, all - read);
        assertThat(mesh.triangles()).isEqualTo(2 * SIDE * SIDE);
        assertThat(all).as("seconds").isLessThan(MOST_SECONDS);
    }
}
