/** All of the command line: the program, its commands, of which the larger ones have packages, and their options; nothing else knows picocli. */
package sunbeam.app.cli;
