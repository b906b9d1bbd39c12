package jrtr;

/** Triangles in graphics memory, uploaded once; made by {@link RenderContext#createVertexBuffer}. */
public interface VertexBuffer extends Resource {

    /** Number of vertices. */
    int vertices();

    /** Number of triangles. */
    int triangles();

    /** A sphere that holds all vertices, for culling. */
    BoundingSphere bounds();
}
