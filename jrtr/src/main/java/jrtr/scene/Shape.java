package jrtr.scene;

import jrtr.gl.VertexBuffer;

/** Leaf node with triangles and a material; owns neither. */
public record Shape(VertexBuffer vertices, Material material) implements Node {}
