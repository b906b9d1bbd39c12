package sunbeam.app.gpu;

import jrtr.GraphicsException;

/** Knows results that shaders mark as unfinished, because the driver ended their loops (shaders/include/loops.glsl). */
public final class CutLoops {
    // LOOPS_CUT is -1e30; what is blended with it is still far below anything that light does.
    private static final float CUT = -1e20f;

    private CutLoops() {}

    /**
     * Lets results through that are whole.
     *
     * @throws GraphicsException where one is not
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
