/** Render thread of the viewer: its loop, the renderer of view states ({@code Stage}) and the exposure. */
package sunbeam.app.viewer.loop;
