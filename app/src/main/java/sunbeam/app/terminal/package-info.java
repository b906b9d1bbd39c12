/** What passes between the program and its user: messages, exit codes, progress, the environment. */
package sunbeam.app.terminal;
