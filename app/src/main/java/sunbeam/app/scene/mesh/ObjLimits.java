package sunbeam.app.scene.mesh;

/**
 * How much an OBJ file may hold; checked while it is read, before memory is taken for what is too much.
 *
 * @param bytes of the file
 * @param elements lines of each kind: positions, normals, texture coordinates
 * @param triangles after division of polygons
 * @param corners of one polygon
 * @param lineLength characters of one line, its continuations included
 */
record ObjLimits(long bytes, int elements, int triangles, int corners, int lineLength) {
    /** Fits into a heap of 1 GiB; a hundred times the thesis's snake. */
    static final ObjLimits STANDARD = new ObjLimits(1L << 29, 2_000_000, 2_000_000, 1000, 1 << 16);
}
