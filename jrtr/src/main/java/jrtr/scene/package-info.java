/** Meshes in world space, lights, and views, without calls of OpenGL. */
package jrtr.scene;
