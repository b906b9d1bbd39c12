package jrtr;

/** Sides of triangles that a draw rasterizes. */
public enum Faces {
    BOTH,
    /**
     * Only triangles that are counter-clockwise in the picture. A closed surface with this winding, seen from outside, looks as with {@link
     * #BOTH}, for half as many triangles.
     */
    FRONT
}
