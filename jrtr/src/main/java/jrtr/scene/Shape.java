package jrtr.scene;

import jrtr.gl.VertexBuffer;

/**
 * A leaf that is drawn: triangles and how they look. Owns neither.
 *
 * @param vertices uploaded once, drawn often
 * @param material how they look
 */
public record Shape(VertexBuffer vertices, Material material) implements Node {}
