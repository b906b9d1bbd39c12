/**
 * The scene graph: groups with a transform; shapes, lights and a camera as leaves; its contents in world space; and views, without calls of
 * OpenGL.
 */
package jrtr.scene;
