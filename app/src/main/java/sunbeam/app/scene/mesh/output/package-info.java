/** Formats of mesh files that are written, with what the body wears. */
package sunbeam.app.scene.mesh.output;
