/** Options that several commands share, and the base class of commands, with their output streams. */
package sunbeam.app.cli.options;
