/** Options of the command line that several commands share. */
package sunbeam.app.cli.options;
