/** Command {@code color}: colors by viewing angle. */
package sunbeam.app.cli.color;
