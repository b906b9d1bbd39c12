/** Command {@code cache}. */
package sunbeam.app.commands.cache;
