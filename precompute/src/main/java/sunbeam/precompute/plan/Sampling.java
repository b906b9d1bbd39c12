package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/** Rule for evaluating the windowed spectrum: the bins or grids to read, and the wavelengths. */
public sealed interface Sampling permits BinSampling, GridSampling, OrderSampling {
    String summary(VisibleRange range);

    /** Formats a range of numbers: "60 to 166", or one number. */
    static String count(int fewest, int most) {
        return fewest == most ? Integer.toString(fewest) : fewest + " to " + most;
    }

    Neighborhood neighborhood();

    /** Returns the loop steps of the slowest pixel; unrolled loops do not count. */
    long loopSteps(SpectrumPlan plan);

    /** Returns the sampling whose tables serve a use. */
    default Sampling serving(MethodUse use) {
        return this;
    }

    /** Returns the shapes of the arrays of {@link #tables}, with an upper limit of layers where unknown. */
    List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use);

    /** Returns the bytes of heap that computing the arrays takes beside the Fourier table. */
    default long workBytes(SpectrumPlan plan) {
        return 0;
    }

    /** Returns the shader's tables, with layers computed on demand; the Fourier table may have fewer terms than the plan. */
    ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie);
}
