/** Readers of mesh files: each checks a file's sizes and returns a {@link sunbeam.app.scene.mesh.format.RawMesh}. */
package sunbeam.app.scene.mesh.format;
