/**
 * The scene graph: groups, shapes, lights, camera, and what draws them. Stands on {@link jrtr} and
 * {@link jrtr.glsl} and names no OpenGL.
 *
 * <p>A scene is what a {@link jrtr.scene.SceneManagerInterface} tells: shapes with their places, lights, a camera and a
 * frustum. {@link jrtr.scene.GraphSceneManager} tells it from a graph of {@link jrtr.scene.Node}s; {@link
 * jrtr.scene.SceneRenderer} draws it. Vertices and textures are uploaded once, by whoever makes the shapes; a change of
 * the scene (a turned group, a moved light, another camera, a material's value) costs uniforms in the next draw only.
 *
 * <p>Nodes are neither thread-safe nor tied to a thread: change and draw a scene on one thread.
 */
package jrtr.scene;
