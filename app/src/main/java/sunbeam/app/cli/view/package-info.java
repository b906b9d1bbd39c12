/** Command {@code view}. */
package sunbeam.app.cli.view;
