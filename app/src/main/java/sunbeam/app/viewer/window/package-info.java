/** Window, status line and presenters. */
package sunbeam.app.viewer.window;
