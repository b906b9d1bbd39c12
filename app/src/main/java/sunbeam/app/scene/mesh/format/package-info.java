/** Formats of mesh files that are read: each makes a {@link sunbeam.app.scene.mesh.format.RawMesh} of a file, whose sizes it checks first. */
package sunbeam.app.scene.mesh.format;
