/** Meshes as files. */
package sunbeam.app.cli.mesh;
