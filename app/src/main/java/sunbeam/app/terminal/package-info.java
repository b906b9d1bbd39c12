/** Words to and from the user at a command line: options, messages, exit codes, the environment. */
package sunbeam.app.terminal;
