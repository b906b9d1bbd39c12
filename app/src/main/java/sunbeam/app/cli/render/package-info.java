/** Commands {@code render} and {@code compare}: pictures and animations of scenes, and scenes beside photographs. */
package sunbeam.app.cli.render;
