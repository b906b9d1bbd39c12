package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** SpectrumPlan of a method for a surface and the directions that can occur. */
public interface MethodPlan {

    /** Returns one line about what is computed. */
    String summary();

    /** Returns a line per choice, with its reason. */
    List<String> reasons();

    /** Returns a line per reason that breaks the tolerance. */
    List<Sentence> warnings();

    /** Returns those warnings that no choice of settings avoids. */
    List<Sentence> shortfalls();

    /** Returns the plan of the sums that the shader takes at every wavelength; empty if it reads tables of colors or takes other sums. */
    default Optional<SpectrumPlan> fullSpectrumPlan() {
        return Optional.empty();
    }

    /** Returns this plan if its tiles are baked on demand, so that {@link #tables} has no texels. */
    default Optional<ColorTablePlan> colorTable() {
        return Optional.empty();
    }

    /** Returns an upper estimate of the tables' memory. */
    MemoryNeed memory();

    /** True if the method supports a use. */
    default boolean answers(MethodUse use) {
        return true;
    }

    /** Returns a text that determines the tables. */
    String key(MethodUse use);

    /**
     * Returns the shader's tables; layers of large arrays are computed on demand.
     *
     * @param use a supported use
     * @param sources of the surface
     */
    ShaderTables tables(MethodUse use, TableSources sources);
}
