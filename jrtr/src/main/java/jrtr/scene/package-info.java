/**
 * Scene graph without calls of OpenGL.
 *
 * <p>Graphs are immutable: an animation makes new graphs of the same shapes, whose vertices and textures stay uploaded.
 */
package jrtr.scene;
