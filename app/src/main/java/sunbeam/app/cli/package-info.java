/** All of the command line: the program, its commands, a package each, and their options; nothing else knows picocli. */
package sunbeam.app.cli;
