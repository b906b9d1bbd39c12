/** Progress and time left, on terminals only. */
package sunbeam.app.terminal.progress;
