package sunbeam.app.scene.mesh;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Quoted;

/**
 * A mesh as a user names it: built in, or from a file.
 *
 * @param mesh complete
 * @param warnings one line each: what was dropped or computed; empty if nothing
 */
public record ReadMesh(Mesh mesh, List<String> warnings) {

    /** Copies the list. */
    public ReadMesh {
        warnings = List.copyOf(warnings);
    }

    /**
     * A built-in mesh by its name, or one from an OBJ file. A file of a built-in mesh's name needs its folder:
     * {@code ./snake}.
     *
     * @param nameOrFile as the user wrote it
     * @param folder where relative files lie
     * @throws InputException if it is neither, or the file cannot be used
     */
    public static ReadMesh load(String nameOrFile, Path folder) {
        if (BuiltInMeshes.names().contains(nameOrFile)) {
            return new ReadMesh(BuiltInMeshes.create(nameOrFile), List.of());
        }
        Path file = folder.resolve(nameOrFile);
        if (!Files.exists(file) && !nameOrFile.contains(".")) {
            throw new InputException("there is no mesh " + Quoted.of(nameOrFile) + "; name an OBJ file, or one of "
                    + String.join(", ", BuiltInMeshes.names()));
        }
        return MeshReader.read(file);
    }
}
