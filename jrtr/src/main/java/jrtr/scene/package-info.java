/**
 * Scene graph without calls of OpenGL.
 *
 * <p>A {@link jrtr.scene.SceneGraph} is a graph of {@link jrtr.scene.Node}s with a {@link jrtr.scene.View}. Graphs are immutable: an
 * animation makes new graphs of the same shapes, whose vertices and textures stay uploaded, so that a change costs uniforms only.
 */
package jrtr.scene;
