/** Scene graph without calls of OpenGL. Graphs are immutable: an animation makes new ones of the same shapes, which stay uploaded. */
package jrtr.scene;
