/**
 * The command {@code view}: {@code model} (scene, undo, background work), {@code loop} (render thread), and here the window with
 * its components, presenters and input. Each uses only those before it. Swing runs on the event thread, OpenGL on the
 * thread of {@link sunbeam.app.viewer.loop.RenderLoop}; objects passed between them are immutable.
 */
package sunbeam.app.viewer;
