/** Meshes as OBJ files. */
package sunbeam.app.commands.mesh;
