/** The render thread: what it draws, in which order, and with what. */
package sunbeam.app.viewer.loop;
