package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.ChebyshevExpansion;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.setting.Sentence;

/** Makes a {@link Plan} for a patch, what the user fixes, and the directions that a scene can reach. */
public final class Planner {
    private static final int THESIS_TERMS = 37;
    private static final double THESIS_WAVELENGTH_STEP = 5e-9;
    private static final Neighbourhood THESIS_NEIGHBOURHOOD = new Neighbourhood(1, Neighbourhood.Anchor.FLOOR);
    private static final double COARSEST_WAVELENGTH_STEP = 1e-9;
    private static final double FINEST_WAVELENGTH_STEP = 0.05e-9;

    private final HeightMap map;
    private final HeightLevels heights;
    private final CieTable cie;
    private final long heapLimit;

    /** A planner for this process's heap. */
    public Planner(HeightMap map, HeightLevels heights, CieTable cie) {
        this(map, heights, cie, Runtime.getRuntime().maxMemory());
    }

    /**
     * A planner.
     *
     * @param heapLimit the most that Java's heap may take, bytes
     */
    public Planner(HeightMap map, HeightLevels heights, CieTable cie, long heapLimit) {
        this.map = map;
        this.heights = heights;
        this.cie = cie;
        this.heapLimit = heapLimit;
    }

    /**
     * The plan: the fastest that keeps the tolerance and fits into memory.
     *
     * @param table what is fixed of tables and wavelengths
     * @param neighbourhood of bins that are to be summed, if any
     * @param area the window, its place, and which power
     * @param range directions that can occur
     * @throws sunbeam.precompute.setting.SettingException when none does, or when what is fixed makes no sense for the patch
     */
    public Plan plan(TableChoices table, Optional<Neighbourhood> neighbourhood, GaussianArea area, VisibleRange range) {
        return plan(table, neighbourhood, area, range, budget(table, neighbourhood, area, range));
    }

    /**
     * The plan of colours under a shorter window than another's whose roughness is known, which takes seconds to measure.
     *
     * @param roughness of the patch under the longer window
     * @throws sunbeam.precompute.setting.SettingException as {@link #plan(TableChoices, Optional, GaussianArea, VisibleRange)}
     */
    public Plan plan(TableChoices table, GaussianArea area, VisibleRange range, Roughness roughness) {
        ErrorBudget budget = new ErrorBudget(budget(table).tolerance(), roughness.under(area.window(), range));
        return plan(table, Optional.empty(), area, range, budget);
    }

    /** How rough the patch is, where that tells between two plans. */
    public Roughness roughness(TableChoices table, GaussianArea area, VisibleRange range) {
        return budget(table, Optional.empty(), area, range).roughness();
    }

    private Plan plan(
            TableChoices table,
            Optional<Neighbourhood> neighbourhood,
            GaussianArea area,
            VisibleRange range,
            ErrorBudget budget) {
        PlanChecks.check(area.window(), map);
        Expansion expansion = expansion(table, range, budget);
        PlanLimits limits = new PlanLimits(map.rows(), heapLimit);
        Plan plan = null;
        for (Sampling sampling : samplings(table, neighbourhood, area, range, budget)) {
            plan = new Plan(
                    table.accuracy(),
                    range,
                    expansion,
                    range.bandX(map.width(), sampling.marginX(area.window(), map.width())),
                    range.bandY(map.height(), sampling.marginY(area.window(), map.height())),
                    area.window(),
                    area.origin(),
                    area.average(),
                    sampling);
            if (limits.hold(plan)) {
                return plan;
            }
        }
        limits.require(plan);
        return plan;
    }

    /** What there is not enough of for some tables, continuing "this plan ..."; nothing where they fit. */
    public Optional<String> excess(MemoryNeed need) {
        return need.excess(heapLimit);
    }

    /** What breaks a plan's tolerance, one line each: what the user fixed, and {@link #shortfalls}. */
    public List<Sentence> warnings(Plan plan) {
        return new PlanWarnings(plan, map).lines();
    }

    /** Why a plan cannot promise its tolerance whatever the user fixes, and what it reaches; one line each. */
    public List<Sentence> shortfalls(Plan plan) {
        return new PlanWarnings(plan, map).shortfalls();
    }

    /** Where the thesis's choices stand in, it keeps no tolerance, and only what a user fixes is planned for the standard one. */
    private static ErrorBudget budget(TableChoices table) {
        return new ErrorBudget(table.accuracy().tolerance().orElse(ErrorBudget.STANDARD));
    }

    private List<Sampling> samplings(
            TableChoices table,
            Optional<Neighbourhood> neighbourhood,
            GaussianArea area,
            VisibleRange range,
            ErrorBudget budget) {
        boolean fixesBins = neighbourhood.isPresent() || table.wavelengthStep().isPresent();
        return table.accuracy().isThesis() || fixesBins
                ? List.of(bins(table, neighbourhood, area.window(), range))
                : new SamplingPlanner(map, heights, area, range, budget).choices();
    }

    private Sampling bins(
            TableChoices table, Optional<Neighbourhood> neighbourhood, CoherenceWindow window, VisibleRange range) {
        boolean thesis = table.accuracy().isThesis();
        double step = table.wavelengthStep()
                .orElseGet(() -> thesis ? THESIS_WAVELENGTH_STEP : wavelengthStep(window, range, budget(table)));
        return new BinSampling(
                neighbourhood.orElseGet(() -> thesis ? THESIS_NEIGHBOURHOOD : neighbourhood(window, budget(table))),
                WavelengthNodes.uniform(cie, step));
    }

    private Neighbourhood neighbourhood(CoherenceWindow window, ErrorBudget budget) {
        double sigmaBins = window.sigmaFrequency() * Math.max(map.width(), map.height());
        int radius = budget.neighbourhoodRadius(sigmaBins);
        PlanChecks.checkRadius(radius, window, sigmaBins);
        return new Neighbourhood(radius, Neighbourhood.Anchor.NEAREST);
    }

    /** Fine enough for the sharpest order, for the colour matching functions, and for textures' longest side. */
    private static double wavelengthStep(CoherenceWindow window, VisibleRange range, ErrorBudget budget) {
        double orders = BinSampling.coarsestWavelengthStep(window, range, budget.tolerance());
        return Math.max(FINEST_WAVELENGTH_STEP, Math.min(COARSEST_WAVELENGTH_STEP, orders));
    }

    /** The budget, with the roughness where it tells between two plans: where a grid is interpolated. */
    private ErrorBudget budget(
            TableChoices table, Optional<Neighbourhood> neighbourhood, GaussianArea area, VisibleRange range) {
        ErrorBudget budget = budget(table);
        boolean free = !table.accuracy().isThesis()
                && neighbourhood.isEmpty()
                && table.wavelengthStep().isEmpty();
        return free && SamplingPlanner.interpolates(map, area.window())
                ? new ErrorBudget(budget.tolerance(), Roughness.measure(map, area.window(), area.origin(), range))
                : budget;
    }

    /** The expansion that a plan has for a patch of which nothing else is known. */
    public Expansion expansion(TableChoices table, VisibleRange range) {
        return expansion(table, range, budget(table));
    }

    private Expansion expansion(TableChoices table, VisibleRange range, ErrorBudget budget) {
        boolean thesis = table.accuracy().isThesis();
        ExpansionKind kind = table.expansion().orElse(thesis ? ExpansionKind.TAYLOR : ExpansionKind.LOWRANK);
        HeightScale scale = thesis ? HeightScale.mean(heights) : HeightScale.midRange(heights);
        double minimum = scale.phase(CieTable.MAXIMUM_WAVELENGTH, range.minimumW());
        double maximum = scale.phase(CieTable.MINIMUM_WAVELENGTH, range.maximumW());
        if (table.terms().isPresent() || thesis) {
            int terms = table.terms().orElse(THESIS_TERMS);
            return switch (kind) {
                case TAYLOR -> PlanChecks.withinFloatRange(new TaylorExpansion(scale, terms, maximum));
                case CHEBYSHEV -> new ChebyshevExpansion(scale, terms, maximum);
                case LOWRANK -> LowRankExpansion.ofTerms(heights, scale, minimum, maximum, terms);
            };
        }
        double tolerance = budget.expansion();
        return switch (kind) {
            case TAYLOR ->
                PlanChecks.accurate(
                        TaylorExpansion.within(scale, maximum, tolerance),
                        budget(table).tolerance());
            case CHEBYSHEV -> ChebyshevExpansion.within(scale, maximum, tolerance);
            case LOWRANK -> LowRankExpansion.within(heights, scale, minimum, maximum, tolerance);
        };
    }
}
