package sunbeam.app.scene.mesh;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.input.InputException;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.precompute.text.Quoted;

/**
 * A loaded mesh, built in or from a file, with warnings.
 *
 * @param warnings one line for each kind of data that the reader dropped, moved or computed
 */
public record ReadMesh(Mesh mesh, List<String> warnings) {

    public ReadMesh {
        warnings = List.copyOf(warnings);
    }

    /**
     * Loads a built-in mesh by its name, or a file. A file with a built-in mesh's name needs its folder: {@code ./snake}.
     *
     * @param source name and unit as the user wrote them
     * @throws InputException if there is no such mesh, or the file cannot be used
     */
    public static ReadMesh load(MeshSource source) {
        String name = source.name();
        if (BuiltInMeshes.names().contains(name)) {
            if (source.unit() != MeshUnit.M) {
                throw new InputException("mesh " + name + " is in meters; leave out the unit, which is for files");
            }
            return new ReadMesh(BuiltInMeshes.create(name), List.of());
        }
        Path file = Path.of(name);
        if (!Files.exists(file) && !name.contains(".")) {
            throw new InputException("there is no mesh " + Quoted.of(name) + "; name a mesh file, or one of "
                    + String.join(", ", BuiltInMeshes.names()));
        }
        return MeshReader.read(file, source.unit());
    }
}
