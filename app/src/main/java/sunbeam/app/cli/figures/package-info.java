/** Command {@code figures}: the thesis's result figures as a folder with an HTML page. */
package sunbeam.app.cli.figures;
