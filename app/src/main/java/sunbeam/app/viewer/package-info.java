/**
 * The command {@code view}: {@code model} (scene, undo, background work), {@code loop} (render thread), {@code components} (parts of the
 * window), and here the window, its presenters and its input. Each uses only those before it. Swing runs on the event thread, OpenGL on the
 * thread of {@link sunbeam.app.viewer.loop.RenderLoop}; objects passed between them are immutable.
 */
package sunbeam.app.viewer;
