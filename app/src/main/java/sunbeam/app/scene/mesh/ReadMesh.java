package sunbeam.app.scene.mesh;

import java.util.List;

/**
 * A mesh from a file.
 *
 * @param mesh complete
 * @param warnings one line each: what was dropped or computed; empty if nothing
 */
public record ReadMesh(Mesh mesh, List<String> warnings) {

    /** Copies the list. */
    public ReadMesh {
        warnings = List.copyOf(warnings);
    }
}
