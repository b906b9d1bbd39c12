package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.ChebyshevExpansion;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.HeightMap;

/** Makes a {@link Plan} for a patch, what the user fixes, and the directions that a scene can reach. */
public final class Planner {
    private static final int THESIS_TERMS = 37;
    private static final double THESIS_WAVELENGTH_STEP = 5e-9;
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
     * @throws PlanException when none does, or when what is fixed makes no sense together
     */
    public Plan plan(PlanRequest request, VisibleRange range) {
        PlanChecks.check(request, map);
        ErrorBudget budget = new ErrorBudget(request.tolerance());
        Plan plan = null;
        for (Sampling sampling : samplings(request, range, budget)) {
            plan = plan(request, range, budget, sampling);
            if (MemoryNeed.of(plan, map.rows()).fits(heapLimit)) {
                break;
            }
        }
        MemoryNeed.of(plan, map.rows()).require(heapLimit, plan);
        return plan;
    }

    /** What the user fixed of a plan that breaks its tolerance, one line each. */
    public List<String> warnings(Plan plan) {
        return new PlanWarnings(plan, map).lines();
    }

    private Plan plan(PlanRequest request, VisibleRange range, ErrorBudget budget, Sampling sampling) {
        return new Plan(
                request.isThesis() ? Double.NaN : budget.tolerance(),
                range,
                expansion(request, range, budget.expansion()),
                range.bandX(map.width(), margin(sampling, request, map.width())),
                range.bandY(map.height(), margin(sampling, request, map.height())),
                request.window(),
                request.windowOrigin(),
                request.average().orElse(Average.COHERENT),
                sampling);
    }

    private List<Sampling> samplings(PlanRequest request, VisibleRange range, ErrorBudget budget) {
        return request.isThesis() || request.fixesBins()
                ? List.of(bins(request, range, budget))
                : new SamplingPlanner(
                                map,
                                heights,
                                request.window(),
                                request.average().orElse(Average.COHERENT),
                                range,
                                budget).choices();
    }

    private Sampling bins(PlanRequest request, VisibleRange range, ErrorBudget budget) {
        boolean thesis = request.isThesis();
        double sigmaBins = request.window().sigmaFrequency() * Math.max(map.width(), map.height());
        int radius = request.radius()
                .orElseGet(() -> thesis ? 1 : budget.neighbourhoodRadius(sigmaBins));
        PlanChecks.checkRadius(radius, sigmaBins);
        Neighbourhood.Anchor anchor =
                request.anchor().orElse(thesis ? Neighbourhood.Anchor.FLOOR : Neighbourhood.Anchor.NEAREST);
        double step = request.wavelengthStep()
                .orElseGet(() -> thesis ? THESIS_WAVELENGTH_STEP : wavelengthStep(request, range, budget));
        return new Sampling.Bins(new Neighbourhood(radius, anchor), WavelengthNodes.uniform(cie, step));
    }

    /** Fine enough for the sharpest order, for the colour matching functions, and for textures' longest side. */
    private static double wavelengthStep(PlanRequest request, VisibleRange range, ErrorBudget budget) {
        double orders = PlanWarnings.coarsestWavelengthStep(request.window(), range, budget.tolerance());
        return Math.max(FINEST_WAVELENGTH_STEP, Math.min(COARSEST_WAVELENGTH_STEP, orders));
    }

    /** Bins beyond the visible ones that the window brings into view. */
    private static int margin(Sampling sampling, PlanRequest request, double period) {
        // One more bin, because float32 may round a frequency into the next one.
        if (sampling instanceof Sampling.Bins bins) {
            return bins.neighbourhood().radius() + 1;
        }
        if (sampling instanceof Sampling.Rays rays) {
            return rays.neighbourhood().radius() + 1;
        }
        return sampling instanceof Sampling.Grid
                ? (int) Math.ceil(SamplingPlanner.GAUSS_REACH * request.window().sigmaFrequency() * period) + 1
                : 1;
    }

    private Expansion expansion(PlanRequest request, VisibleRange range, double tolerance) {
        boolean thesis = request.isThesis();
        ExpansionKind kind = request.expansion().orElse(thesis ? ExpansionKind.TAYLOR : ExpansionKind.LOWRANK);
        HeightScale scale = thesis ? HeightScale.mean(heights) : HeightScale.midRange(heights);
        double minimum = scale.phase(CieTable.MAXIMUM_WAVELENGTH, range.minimumW());
        double maximum = scale.phase(CieTable.MINIMUM_WAVELENGTH, range.maximumW());
        if (request.terms().isPresent() || thesis) {
            int terms = request.terms().orElse(THESIS_TERMS);
            return switch (kind) {
                case TAYLOR -> PlanChecks.withinFloatRange(new TaylorExpansion(scale, terms, maximum));
                case CHEBYSHEV -> new ChebyshevExpansion(scale, terms, maximum);
                case LOWRANK -> LowRankExpansion.ofTerms(heights, scale, minimum, maximum, terms);
            };
        }
        return switch (kind) {
            case TAYLOR -> PlanChecks.accurate(TaylorExpansion.within(scale, maximum, tolerance), request.tolerance());
            case CHEBYSHEV -> ChebyshevExpansion.within(scale, maximum, tolerance);
            case LOWRANK -> LowRankExpansion.within(heights, scale, minimum, maximum, tolerance);
        };
    }
}
