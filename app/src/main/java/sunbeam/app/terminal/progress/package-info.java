/** Progress and time left, on a terminal, and sparsely elsewhere. */
package sunbeam.app.terminal.progress;
