/** Meshes as files. */
package sunbeam.app.commands.mesh;
