/** Render thread of the viewer: order of work, stages, exposure. */
package sunbeam.app.viewer.loop;
