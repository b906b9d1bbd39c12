/** Swing components of the window. */
package sunbeam.app.viewer.components;
