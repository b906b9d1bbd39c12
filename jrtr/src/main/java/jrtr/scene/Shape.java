package jrtr.scene;

import jrtr.gl.VertexBuffer;

/**
 * Leaf node with triangles and a material. Owns neither.
 *
 * @param vertices uploaded once, drawn often
 * @param material program, textures and uniforms of the draw
 */
public record Shape(VertexBuffer vertices, Material material) implements Node {}
