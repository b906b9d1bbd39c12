package sunbeam.app.scene.mesh;

import sunbeam.app.scene.mesh.format.MeshUnit;

/**
 * Name of a mesh, and its unit.
 *
 * @param name a built-in mesh, or a file: OBJ, PLY or glTF
 * @param unit unit of the file's numbers; meters for built-in meshes
 */
public record MeshSource(String name, MeshUnit unit) {
    /** Creates the source of a built-in mesh, or of a file in meters. */
    public static MeshSource of(String name) {
        return new MeshSource(name, MeshUnit.M);
    }
}
