/** Command {@code mesh}. */
package sunbeam.app.cli.mesh;
