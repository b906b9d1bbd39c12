/** Command {@code inspect}: properties of a patch's heights, as text and as plots on one sheet. */
package sunbeam.app.cli.inspect;
