package sunbeam.app.scene.mesh;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Reads mesh files, OBJ, PLY and glTF: positions with z up, faces of 3 to 1000 corners, without lines, points and materials; a glTF's first
 * texture selects the texture coordinates. It repairs a mesh, and warns of what it changed:
 *
 * <ul>
 * <li>Triangles without area are dropped. A mesh far from the origin is moved there, because float32 would change its shape.
 * <li>Missing normals are means over the triangles around a position ({@link VertexAssembly}).
 * <li>Missing tangents follow the texture's u, or x (y where the surface faces along x) where it gives no direction; a mirrored texture
 *       gives a left-handed frame.
 * <li>If a face lacks texture coordinates, all are projected from above: x to u and y to v, the longer side from 0 to 1, right-handed.
 * </ul>
 */
public final class MeshReader {
    // Longest side in meters: pixels of a smaller mesh do not average many coherence areas of sunlight (65 um); a
    // larger one has more than
    // a centimeter per pixel, most likely in a wrong unit.
    private static final double LEAST = 100e-6;
    private static final double MOST = 10;

    private MeshReader() {}

    /** Reads a file of at most 512 MiB, 2 million positions and 2 million triangles. */
    static MeshSource.Loaded read(Path file, MeshUnit unit) {
        RawMesh raw = MeshFormat.read(file).inMeters(unit);
        List<String> warnings = new ArrayList<>();
        RawMesh mesh = raw.withoutDegenerate();
        int dropped = (raw.cornerCount() - mesh.cornerCount()) / 3;
        if (raw.cornerCount() == 0) {
            throw new InputException(file + " has no faces; name a mesh with faces as OBJ, PLY or glTF");
        }
        if (mesh.cornerCount() == 0) {
            throw new InputException(file + " has no face with an area");
        }
        if (dropped > 0) {
            warnings.add(file + ": dropped " + count(dropped, "triangle") + " without area");
        }
        Optional<Vector3d> far = mesh.farCenter();
        far.ifPresent(center -> warnings.add(Text.format(
                "%s: it lies far from the origin, so its center (%.3f, %.3f, %.3f) m is moved there",
                file, center.x, center.y, center.z)));
        return complete(file, unit, far.map(mesh::centered).orElse(mesh), warnings);
    }

    private static MeshSource.Loaded complete(Path file, MeshUnit unit, RawMesh mesh, List<String> warnings) {
        boolean planar = IntStream.range(0, mesh.cornerCount()).anyMatch(corner -> mesh.textureCoordinate(corner) < 0);
        if (planar) {
            warnings.add(file + ": texture coordinates are missing; they are taken from above (x, y)");
        }
        VertexAssembly assembly = new VertexAssembly(planar ? mesh.withPlanarCoordinates() : mesh, planar);
        Mesh result = assembly.assemble();
        sizeWarning(result, unit).ifPresent(line -> warnings.add(file + ": " + line));
        if (assembly.computedNormals() > 0) {
            warnings.add(file + ": computed normals for " + assembly.computedNormals() + " of "
                    + count(result.vertices(), "vertex"));
        }
        if (!planar && assembly.undirected() > 0) {
            warnings.add(file + ": the texture gives no direction at " + count(assembly.undirected(), "vertex")
                    + "; the tangent follows x there");
        }
        return new MeshSource.Loaded(result, warnings);
    }

    public static String count(int number, String noun) {
        String plural = noun.equals("vertex") ? "vertices" : noun + "s";
        return number + " " + (number == 1 ? noun : plural);
    }

    private static Optional<String> sizeWarning(Mesh mesh, MeshUnit unit) {
        double side = longestSide(mesh);
        if (isPlausible(side)) {
            return Optional.empty();
        }
        String remedy = Stream.of(MeshUnit.MM, MeshUnit.CM, MeshUnit.IN, MeshUnit.M, MeshUnit.UM)
                .filter(other -> isPlausible(side / unit.meters() * other.meters()))
                .findFirst()
                .map(other -> other.name().toLowerCase(Locale.ROOT))
                .map(word -> "if its numbers are in " + word + ", give --mesh-unit " + word
                        + ", in a scene \"meshUnit\": \"" + word + "\"")
                .orElse("scale it");
        return Optional.of("the mesh is " + Lengths.rounded(side, 3) + " wide, where " + Lengths.format(LEAST) + " to "
                + Lengths.format(MOST) + " make sense; " + remedy);
    }

    private static boolean isPlausible(double side) {
        return side >= LEAST && side <= MOST;
    }

    private static double longestSide(Mesh mesh) {
        double longest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < mesh.positions().length; i += 3) {
                least = Math.min(least, mesh.positions()[i]);
                most = Math.max(most, mesh.positions()[i]);
            }
            longest = Math.max(longest, most - least);
        }
        return longest;
    }
}
