/** The thesis's result figures as one folder with a page. */
package sunbeam.app.cli.figures;
