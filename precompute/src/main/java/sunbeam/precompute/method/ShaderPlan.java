package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * SpectrumPlan of a method whose tables are made as a whole.
 *
 * @param spectrum plan of the sums that the shader takes, or from which its tables are baked; empty if there is none
 * @param isTabulated whether the shader reads tables of colors and takes no sums
 * @param uses supported uses
 * @param explanation each choice with its reason, computed when needed
 * @param identity text that determines the tables, except for the use; computed when needed
 * @param maker makes the tables for a use
 */
record ShaderPlan(
        String summary,
        Supplier<List<String>> explanation,
        Optional<SpectrumPlan> spectrum,
        boolean isTabulated,
        MemoryNeed memory,
        Set<MethodUse> uses,
        Supplier<String> identity,
        BiFunction<MethodUse, TableSources, ShaderTables> maker)
        implements MethodPlan {
    @Override
    public List<String> reasons() {
        return explanation.get();
    }

    @Override
    public List<Sentence> warnings() {
        return spectrum.map(SpectrumPlan::warnings).orElse(List.of());
    }

    @Override
    public List<Sentence> shortfalls() {
        return spectrum.map(SpectrumPlan::shortfalls).orElse(List.of());
    }

    @Override
    public Optional<SpectrumPlan> fullSpectrumPlan() {
        return isTabulated ? Optional.empty() : spectrum;
    }

    @Override
    public boolean answers(MethodUse use) {
        return uses.contains(use);
    }

    @Override
    public String key(MethodUse use) {
        return identity.get() + "|" + use;
    }

    @Override
    public ShaderTables tables(MethodUse use, TableSources sources) {
        return maker.apply(use, sources);
    }
}
