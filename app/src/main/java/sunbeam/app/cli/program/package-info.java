/** The program: parses command lines, runs commands and describes them. */
package sunbeam.app.cli.program;
