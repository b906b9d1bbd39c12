package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/** Rule by which the windowed spectrum is read off the DFT bins, at which wavelengths; with its cost and its shader's tables. */
public sealed interface Sampling permits BinSampling, GridSampling, OrderSampling {

    /** Returns what is summed or interpolated, and at how many wavelengths, in a few words. */
    String summary(VisibleRange range);

    /** Formats a range: "60 to 166", or one number. */
    static String count(int fewest, int most) {
        return fewest == most ? Integer.toString(fewest) : fewest + " to " + most;
    }

    /** Returns the bins around a frequency that the window sees. */
    Neighborhood around(CoherenceWindow window, HeightMap map);

    /** Returns the loop steps of the slowest pixel; unrolled loops do not count. */
    long loopSteps(SpectrumPlan plan);

    /** Returns the shapes of the arrays of {@link #tables}, with an upper limit of layers where unknown. */
    List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use);

    /** Returns the bytes of heap, beside the Fourier table, while the arrays are made. */
    default long workBytes(SpectrumPlan plan) {
        return 0;
    }

    /**
     * Returns the shader's tables; layers of arrays are computed on demand.
     *
     * @param plan with this sampling
     * @param table made for the plan; may have fewer terms
     */
    ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie);
}
