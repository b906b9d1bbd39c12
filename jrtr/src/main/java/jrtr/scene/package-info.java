/**
 * The scene graph: groups, shapes, lights, camera, and what draws them. Stands on {@link jrtr} and
 * {@link jrtr.glsl} and names no OpenGL.
 *
 * <p>A {@link jrtr.scene.SceneGraph} is a graph of {@link jrtr.scene.Node}s, a camera and a frustum; {@link
 * jrtr.scene.SceneRenderer} draws it. Graphs are values: what moves is a new graph of the same shapes, whose vertices and
 * textures are uploaded once, so that it costs uniforms in the next draw only.
 */
package jrtr.scene;
