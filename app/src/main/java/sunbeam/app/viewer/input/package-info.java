/** Mouse and key input. */
package sunbeam.app.viewer.input;
