/**
 * Scene graph: groups, shapes, lights, camera, and their renderer, without calls of OpenGL.
 *
 * <p>A {@link jrtr.scene.SceneGraph} is a graph of {@link jrtr.scene.Node}s, a camera and a frustum; {@link
 * jrtr.scene.SceneRenderer} draws it. Graphs are immutable: an animation makes new graphs of the same shapes, whose vertices and
 * textures stay uploaded, so that a change costs uniforms only.
 */
package jrtr.scene;
