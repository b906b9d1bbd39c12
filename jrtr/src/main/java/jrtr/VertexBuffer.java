package jrtr;

/** Triangles in graphics memory, uploaded once; made by {@link RenderContext#createVertexBuffer}. */
public interface VertexBuffer extends Resource {

    /** A sphere that holds all vertices, for culling. */
    BoundingSphere bounds();
}
