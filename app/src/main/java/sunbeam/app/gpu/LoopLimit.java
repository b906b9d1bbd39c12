package sunbeam.app.gpu;

import jrtr.GraphicsException;

/** Refuses partial sums, which shaders mark where the driver ended their loops (shaders/include/loops.glsl). */
public final class LoopLimit {
    // LOOPS_CUT is -1e30; blended with other light it stays far below every valid result.
    private static final float CUT = -1e20f;

    private LoopLimit() {}

    /**
     * Returns results without partial sums.
     *
     * @throws GraphicsException if one of them is a partial sum
     */
    public static float[] checked(float[] results) {
        for (float result : results) {
            if (result < CUT) {
                throw new GraphicsException(
                        "the graphics driver ended a shader's loops before they were done, as Mesa's"
                                + " software renderer does after 65,535 steps, and what they summed is wrong; give a coarser tolerance,"
                                + " method table, a longer coherence length or a smaller neighborhood");
            }
        }
        return results;
    }
}
