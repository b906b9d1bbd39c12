/** Command {@code compare}: compares a photograph with a rendered scene. */
package sunbeam.app.cli.compare;
