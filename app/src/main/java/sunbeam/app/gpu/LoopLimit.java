package sunbeam.app.gpu;

import jrtr.GraphicsException;

/** Refuses results of shaders whose loops the driver ended early: partial sums, which shaders mark (shaders/include/loops.glsl). */
public final class LoopLimit {
    // The shaders' mark LOOPS_CUT is -1e30. Weighted and added to other light it stays below this limit; valid results
    // stay above it.
    private static final float LARGEST_PARTIAL_SUM = -1e20f;

    private LoopLimit() {}

    /**
     * Returns the results, unchanged.
     *
     * @throws GraphicsException if one of them is a partial sum
     */
    public static float[] checked(float[] results) {
        for (float result : results) {
            if (result < LARGEST_PARTIAL_SUM) {
                throw new GraphicsException(
                        "the graphics driver ended a shader's loops before they were done, as Mesa's"
                                + " software renderer does after 65,535 steps, and what they summed is wrong; give a coarser tolerance,"
                                + " method table, a longer coherence length or a smaller neighborhood");
            }
        }
        return results;
    }
}
