package jrtr;

/** What a draw of triangles does with the target's depth. Nearer is less. */
public enum DepthUse {
    /** Draws colours and depth where the fragment is nearer than what is there. */
    NEARER,
    /** Writes depth only, where nearer: the first pass of two. */
    DEPTH_ONLY,
    /**
     * Draws colours where the fragment is as near as the depth there, and leaves the depth: the second pass. Each
     * pixel's fragment shader then runs once. Depths agree exactly between programs with the same vertex shader and the
     * same values of its uniforms.
     */
    EQUAL
}
