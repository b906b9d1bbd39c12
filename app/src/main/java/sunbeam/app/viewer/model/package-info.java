/** Model of the viewer: scene, undo history, background work. */
package sunbeam.app.viewer.model;
