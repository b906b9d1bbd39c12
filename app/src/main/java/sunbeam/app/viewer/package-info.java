/**
 * The command {@code view}. Each of its packages uses only packages before it in this list: {@code model}, {@code loop}, {@code panel},
 * {@code picture}, {@code pick}, {@code window}, {@code input}. Swing runs on the event thread, OpenGL on the thread of {@link
 * sunbeam.app.viewer.loop.RenderLoop}; objects passed between them are immutable.
 */
package sunbeam.app.viewer;
