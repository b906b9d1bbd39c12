package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/**
 * How the windowed spectrum is read off the DFT bins, and at which wavelengths: what it is in words, what it takes, and
 * the tables of its shader.
 */
public sealed interface Sampling permits BinSampling, GridSampling, OrderSampling {

    /** What is summed or interpolated, and at how many wavelengths, in a few words. */
    String summary(VisibleRange range);

    /** "60 to 166", or one number where both are equal. */
    static String count(int fewest, int most) {
        return fewest == most ? Integer.toString(fewest) : fewest + " to " + most;
    }

    /** The bins around a frequency that the window brings into its view. */
    Neighborhood around(CoherenceWindow window, HeightMap map);

    /** Steps that the loops of the pixel that takes most make together, but for those that compilers write out. */
    long loopSteps(Plan plan);

    /** Shapes of the arrays that {@link #tables} holds; where their number of layers is not known yet, at most. */
    List<ArrayLayout> layouts(Plan plan, MethodUse use);

    /** Bytes in Java's heap, beside the Fourier table, while the arrays are made. */
    default long workBytes(Plan plan) {
        return 0;
    }

    /**
     * What the shader reads. Layers of arrays are made when they are asked for.
     *
     * @param plan that has this sampling
     * @param table made for the plan; it may have fewer terms
     */
    ShaderTables tables(Plan plan, FourierTable table, MethodUse use, CieTable cie);
}
