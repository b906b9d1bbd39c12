/** What mouse and keys do. */
package sunbeam.app.viewer.input;
