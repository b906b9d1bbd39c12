/** Command {@code cache}. */
package sunbeam.app.cli.cache;
