package jrtr.scene;

import jrtr.gl.VertexBuffer;

/**
 * Leaf of a scene graph: a mesh with its material. Owns neither.
 *
 * @param closed whether the triangles enclose a body, of which only fronts are visible from outside
 */
public record Shape(VertexBuffer mesh, boolean closed, Material material) implements Node {}
