package jrtr;

/** Which sides of triangles are drawn. */
public enum Faces {
    BOTH,
    /**
     * Those that are counter-clockwise in the picture. Of a surface that is closed, wound so and seen from outside, that is the same
     * picture, made of half the triangles.
     */
    FRONT
}
