/** Interface of the program to its user's terminal: messages, exit codes, progress, the environment. */
package sunbeam.app.terminal;
