/**
 * The interactive viewer. Swing lives on the event thread, OpenGL on {@link sunbeam.app.viewer.RenderLoop}'s; what passes
 * between them is immutable.
 */
package sunbeam.app.viewer;
