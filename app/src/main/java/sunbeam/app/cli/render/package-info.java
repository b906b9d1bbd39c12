/** Command {@code render}: pictures and animations of scenes. */
package sunbeam.app.cli.render;
