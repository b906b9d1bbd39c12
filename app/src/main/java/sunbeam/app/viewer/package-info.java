/**
 * The command {@code view}. Rooms below it, each of which knows those before it: {@code model} (the scene that is seen), {@code loop} (the render thread),
 * {@code panel} (controls), {@code picture} (what is painted), {@code pick} (points of the skin), {@code window} (all of them together) and {@code input}
 * (mouse and keys). Swing lives on the event thread, OpenGL on {@link sunbeam.app.viewer.loop.RenderLoop}'s; what passes between them is immutable.
 */
package sunbeam.app.viewer;
