/**
 * The command {@code view}. Each of its packages uses only packages named before it: {@code model} (the scene), {@code loop} (the render
 * thread), {@code panel} (controls), {@code picture} (painted components), {@code pick} (picked points), {@code window} (the window and its
 * presenters) and {@code input} (mouse and keys). Swing runs on the event thread, OpenGL on the thread of {@link
 * sunbeam.app.viewer.loop.RenderLoop}; objects passed between them are immutable.
 */
package sunbeam.app.viewer;
