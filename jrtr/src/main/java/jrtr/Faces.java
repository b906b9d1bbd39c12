package jrtr;

/** Sides of triangles that a draw rasterizes. */
public enum Faces {
    BOTH,
    /**
     * Triangles that are counter-clockwise in the picture. For a closed surface with this winding, seen from outside, the picture
     * equals that of {@link #BOTH} at half the triangles.
     */
    FRONT
}
