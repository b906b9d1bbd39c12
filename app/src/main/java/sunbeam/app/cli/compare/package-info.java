/** Command {@code compare}: a photograph beside a rendered scene. */
package sunbeam.app.cli.compare;
