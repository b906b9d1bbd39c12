package sunbeam.app.scene.mesh;

import sunbeam.app.scene.mesh.format.MeshUnit;

/**
 * A mesh as a user names it.
 *
 * @param name a built-in mesh, or a file: OBJ, PLY or glTF
 * @param unit of the file's numbers; meters for built-in meshes
 */
public record MeshSource(String name, MeshUnit unit) {
    /** Built in, or a file in meters. */
    public static MeshSource of(String name) {
        return new MeshSource(name, MeshUnit.M);
    }
}
