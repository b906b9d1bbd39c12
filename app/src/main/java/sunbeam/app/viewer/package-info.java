/**
 * The command {@code view}. Its packages, each of which uses those before it: {@code model} (the scene), {@code loop} (the render thread),
 * {@code panel} (controls), {@code picture} (painted components), {@code pick} (picked points), {@code window} (the window and its
 * presenters) and {@code input} (mouse and keys). Swing lives on the event thread, OpenGL on {@link sunbeam.app.viewer.loop.RenderLoop}'s;
 * objects passed between them are immutable.
 */
package sunbeam.app.viewer;
