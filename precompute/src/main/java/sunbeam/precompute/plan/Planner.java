package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Makes a {@link SpectrumPlan} from a patch, the user's choices, and the directions that a scene can reach.
 *
 * @param heapLimit largest size of Java's heap, bytes
 * @param mostSteps limit of a shader's loop steps per pixel
 */
public record Planner(
        HeightMap map, HeightLevels heights, CieTable cie, long heapLimit, long mostSteps, StatisticsCache statistics) {
    private static final int THESIS_TERMS = 37;

    public Planner(HeightMap map, HeightLevels heights, CieTable cie) {
        this(map, heights, cie, Runtime.getRuntime().maxMemory());
    }

    Planner(HeightMap map, HeightLevels heights, CieTable cie, long heapLimit) {
        this(map, heights, cie, heapLimit, PlanChecks.MOST_LOOP_STEPS, StatisticsCache.NONE);
    }

    public Planner withStatistics(StatisticsCache newStatistics) {
        return new Planner(map, heights, cie, heapLimit, mostSteps, newStatistics);
    }

    /** Color tables of the ensemble average are summed on the CPU, without a shader's limit on loops. */
    public Planner ofTables(Average average) {
        return average == Average.ENSEMBLE
                ? new Planner(map, heights, cie, heapLimit, Long.MAX_VALUE, statistics)
                : this;
    }

    /**
     * Returns the fastest plan that keeps the tolerance and fits into memory.
     *
     * @throws sunbeam.precompute.setting.SettingException if there is none, or if a choice does not suit the patch
     */
    public SpectrumPlan plan(TableChoices choices, GaussianArea area, VisibleRange range) {
        return plan(choices, area, range, roughness(choices, area, range));
    }

    /**
     * Plans for a patch of known roughness, which takes seconds to measure.
     *
     * @param roughness roughness of the patch, measured under this window or a longer one
     */
    public SpectrumPlan plan(TableChoices choices, GaussianArea area, VisibleRange range, Roughness roughness) {
        PlanChecks.requireSamples(area.window(), map);
        ErrorBudget budget = new ErrorBudget(choices.tolerance(), roughness.withWindow(area.window(), range));
        Expansion expansion = expansion(choices, range, budget);
        SpectrumPlan plan = null;
        for (Supplier<Sampling> choice : samplings(choices, area, range, budget)) {
            Sampling sampling = choice.get();
            Neighborhood around = sampling.around(area.window(), map);
            plan = new SpectrumPlan(
                    choices.promisedTolerance(),
                    range,
                    expansion,
                    range.bandX(map.width(), around.marginX()),
                    range.bandY(map.height(), around.marginY()),
                    area.window(),
                    area.origin(),
                    area.average(),
                    sampling);
            if (PlanChecks.excess(plan, map.rows(), heapLimit, mostSteps).isEmpty()) {
                return plan;
            }
        }
        throw PlanChecks.tooLarge(plan, map.rows(), heapLimit, mostSteps);
    }

    /**
     * Returns the roughness of the patch if the plan may interpolate the spectrum on a grid of frequencies; otherwise {@link
     * Roughness#NONE}.
     */
    public Roughness roughness(TableChoices choices, GaussianArea area, VisibleRange range) {
        return !choices.fixesBins() && SamplingPlanner.interpolates(map, area.window())
                ? Roughness.measure(map, area.window(), area.origin(), range, statistics)
                : Roughness.NONE;
    }

    private List<Supplier<Sampling>> samplings(
            TableChoices choices, GaussianArea area, VisibleRange range, ErrorBudget budget) {
        return choices.fixesBins()
                ? List.of(() -> BinSampling.of(choices, area.window(), map, cie))
                : new SamplingPlanner(map, heights, cie, area, range, budget).choices();
    }

    /** Returns which limit a need of memory exceeds, as the end of a sentence that begins with "this plan"; empty if it fits. */
    public Optional<String> excess(MemoryNeed need) {
        return need.excess(heapLimit);
    }

    public Expansion expansion(TableChoices choices, VisibleRange range) {
        return expansion(choices, range, new ErrorBudget(choices.tolerance()));
    }

    private Expansion expansion(TableChoices choices, VisibleRange range, ErrorBudget budget) {
        boolean thesis = choices.isThesis();
        Expansion.Kind kind = choices.expansion().orElse(thesis ? Expansion.Kind.TAYLOR : Expansion.Kind.LOWRANK);
        HeightScale scale = thesis ? HeightScale.mean(heights) : HeightScale.midRange(heights);
        double minimum = scale.phase(CieTable.MAXIMUM_WAVELENGTH, range.minimumW());
        double maximum = scale.phase(CieTable.MINIMUM_WAVELENGTH, range.maximumW());
        if (kind == Expansion.Kind.LOWRANK) {
            PlanChecks.requireExpandable(scale, maximum);
        }
        if (choices.terms().isPresent() || thesis) {
            int terms = choices.terms().orElse(THESIS_TERMS);
            return switch (kind) {
                case TAYLOR -> PlanChecks.withinFloatRange(new TaylorExpansion(scale, terms, maximum));
                case LOWRANK -> LowRankExpansion.ofTerms(heights, scale, minimum, maximum, terms);
            };
        }
        double tolerance = budget.expansion();
        return switch (kind) {
            case TAYLOR -> PlanChecks.accurate(TaylorExpansion.within(scale, maximum, tolerance), budget.tolerance());
            case LOWRANK -> LowRankExpansion.within(heights, scale, minimum, maximum, tolerance);
        };
    }
}
