package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Plan of a method whose tables are made as a whole.
 *
 * @param summary one line: what is computed
 * @param reasons each choice and its reason
 * @param spectrum plan of the sums that the shader takes, or of those that its tables are made of; empty where there are none
 * @param isTabulated whether colors of these sums are tabulated, and the shader takes none
 * @param memory what the tables take, at most
 * @param uses that the method has an answer for
 * @param key all that determines the tables beside the use
 * @param maker makes the tables for one of the uses
 */
record ShaderPlan(
        String summary,
        List<String> reasons,
        Optional<Plan> spectrum,
        boolean isTabulated,
        MemoryNeed memory,
        Set<MethodUse> uses,
        String key,
        BiFunction<MethodUse, TableSources, ShaderTables> maker)
        implements MethodPlan {
    @Override
    public List<Sentence> warnings() {
        return spectrum.map(Plan::warnings).orElse(List.of());
    }

    @Override
    public List<Sentence> shortfalls() {
        return spectrum.map(Plan::shortfalls).orElse(List.of());
    }

    @Override
    public Optional<Plan> sums() {
        return isTabulated ? Optional.empty() : spectrum;
    }

    @Override
    public boolean answers(MethodUse use) {
        return uses.contains(use);
    }

    @Override
    public String key(MethodUse use) {
        return key + "|" + use;
    }

    @Override
    public ShaderTables tables(MethodUse use, TableSources sources) {
        return maker.apply(use, sources);
    }
}
