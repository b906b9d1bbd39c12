package sunbeam.app.scene.mesh;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import sunbeam.app.files.input.InputException;
import sunbeam.app.scene.mesh.format.MeshFormat;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.app.scene.mesh.format.RawMesh;
import sunbeam.precompute.text.Text;

/**
 * Reads mesh files, OBJ, PLY and glTF: positions with z up (glTF's y up is turned), faces of 3 to 1000 corners. Lines and points are
 * ignored, as are materials, except that a glTF's first texture selects the texture coordinates.
 *
 * <p>The reader repairs and completes a mesh, and warns of what it changed:
 *
 * <ul>
 * <li>Triangles without area are dropped.
 * <li>A mesh far from the origin, in map coordinates for example, is moved to the origin, because float32 would change its shape.
 * <li>Missing normals are computed as means over the triangles around a position ({@link CornerNormals}).
 * <li>Missing tangents (only glTF may have some) follow the texture's u, made orthogonal to the normal; a mirrored texture gives
 *       a left-handed frame. Where the texture gives no direction the tangent follows x (y where the surface faces along
 *       x).
 * <li>If any face lacks texture coordinates, all get new ones, projected from above: x to u and y to v, the longer side from 0 to 1.
 * Tangents then follow x, and all frames are right-handed.
 * </ul>
 */
public final class MeshReader {
    private MeshReader() {}

    /** Reads a file of at most 512 MiB, 2 million positions and 2 million triangles. */
    static ReadMesh read(Path file, MeshUnit unit) {
        RawMesh raw = MeshFormat.of(file).read(file).inMeters(unit);
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

    private static ReadMesh complete(Path file, MeshUnit unit, RawMesh mesh, List<String> warnings) {
        boolean planar = IntStream.range(0, mesh.cornerCount()).anyMatch(corner -> mesh.textureCoordinate(corner) < 0);
        if (planar) {
            warnings.add(file + ": texture coordinates are missing; they are taken from above (x, y)");
        }
        VertexAssembly assembly = new VertexAssembly(planar ? mesh.withPlanarCoordinates() : mesh, planar);
        Mesh result = assembly.assemble();
        MeshSize.warning(result, unit).ifPresent(line -> warnings.add(file + ": " + line));
        if (assembly.computedNormals() > 0) {
            warnings.add(file + ": computed normals for " + assembly.computedNormals() + " of "
                    + count(result.vertices(), "vertex"));
        }
        if (!planar && assembly.undirected() > 0) {
            warnings.add(file + ": the texture gives no direction at " + count(assembly.undirected(), "vertex")
                    + "; the tangent follows x there");
        }
        return new ReadMesh(result, warnings);
    }

    public static String count(int number, String noun) {
        String plural = noun.equals("vertex") ? "vertices" : noun + "s";
        return number + " " + (number == 1 ? noun : plural);
    }
}
