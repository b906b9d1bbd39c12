package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** A method planned for a surface and the directions that can occur. */
public interface MethodPlan {

    /** One line: what is computed. */
    String summary();

    /** Several lines: each choice and its reason. */
    List<String> reasons();

    /** What breaks the tolerance, one line each. */
    List<Sentence> warnings();

    /** Those of them that say that the tolerance cannot be promised, whatever is chosen. */
    List<Sentence> shortfalls();

    /** The plan whose sums the shader takes at every wavelength, where it takes nothing else. */
    default Optional<Plan> sums() {
        return Optional.empty();
    }

    /** The same where its tables are made as they are looked at: what it gives at once are settings without texels. */
    default Optional<ColorTablePlan> colorTable() {
        return Optional.empty();
    }

    /** What the tables take, at most. */
    MemoryNeed memory();

    /** Whether the method has an answer for a use. */
    default boolean answers(MethodUse use) {
        return true;
    }

    /** All that determines the tables, as text: equal texts mean equal tables. */
    String key(MethodUse use);

    /**
     * What the method's shader reads. Layers of large arrays are made when they are asked for.
     *
     * @param use one that the method answers
     * @param sources of the surface
     */
    ShaderTables tables(MethodUse use, TableSources sources);
}
