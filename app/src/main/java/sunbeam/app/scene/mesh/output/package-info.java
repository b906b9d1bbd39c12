/** Writers of mesh files, with the body's skin. */
package sunbeam.app.scene.mesh.output;
