package sunbeam.app.scene.mesh;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Quoted;

/**
 * Mesh by name. A file with a built-in mesh's name needs its folder: {@code ./snake}.
 *
 * @param name a built-in mesh, or a file: OBJ, PLY or glTF
 * @param unit unit of the file's numbers; meters for built-in meshes
 */
public record MeshSource(String name, MeshUnit unit) {
    /** Mesh with a line for each kind of data that the reader dropped, moved or computed. */
    public record Loaded(Mesh mesh, List<String> warnings) {
        public Loaded {
            warnings = List.copyOf(warnings);
        }
    }

    public static MeshSource of(String name) {
        return new MeshSource(name, MeshUnit.M);
    }

    /** @throws InputException if there is no such mesh, or the file cannot be used */
    public Loaded load() {
        if (BuiltInMeshes.names().contains(name)) {
            if (unit != MeshUnit.M) {
                throw new InputException("mesh " + name + " is in meters; leave out the unit, which is for files");
            }
            return new Loaded(BuiltInMeshes.create(name), List.of());
        }
        Path file = Path.of(name);
        if (!Files.exists(file) && !name.contains(".")) {
            throw new InputException("there is no mesh " + Quoted.of(name) + "; name a mesh file, or one of "
                    + String.join(", ", BuiltInMeshes.names()));
        }
        return MeshReader.read(file, unit);
    }
}
