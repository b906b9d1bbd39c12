package sunbeam.precompute.plan;

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
    // Error of the expansion where its terms are not fixed.
    private static final double EXPANSION_TOLERANCE = 1e-5;

    private final HeightMap map;
    private final HeightLevels heights;
    private final CieTable cie;

    public Planner(HeightMap map, HeightLevels heights, CieTable cie) {
        this.map = map;
        this.heights = heights;
        this.cie = cie;
    }

    /** The plan. */
    public Plan plan(PlanRequest request, VisibleRange range) {
        boolean thesis = request.preset() == PlanRequest.Preset.THESIS;
        Neighbourhood neighbourhood = new Neighbourhood(
                request.radius().orElse(thesis ? 1 : 3),
                request.anchor().orElse(thesis ? Neighbourhood.Anchor.FLOOR : Neighbourhood.Anchor.NEAREST));
        // One more bin, because float32 may round a frequency into the next one.
        int margin = neighbourhood.radius() + 1;
        return new Plan(
                expansion(request, range),
                range.bandX(map.width(), margin),
                range.bandY(map.height(), margin),
                request.window(),
                request.windowOrigin(),
                neighbourhood,
                request.average().orElse(Average.COHERENT),
                WavelengthNodes.uniform(cie, request.wavelengthStep().orElse(THESIS_WAVELENGTH_STEP)));
    }

    private Expansion expansion(PlanRequest request, VisibleRange range) {
        boolean thesis = request.preset() == PlanRequest.Preset.THESIS;
        ExpansionKind kind = request.expansion().orElse(thesis ? ExpansionKind.TAYLOR : ExpansionKind.CHEBYSHEV);
        HeightScale scale = thesis ? HeightScale.mean(heights) : HeightScale.midRange(heights);
        double minimum = scale.phase(CieTable.MAXIMUM_WAVELENGTH, range.minimumW());
        double maximum = scale.phase(CieTable.MINIMUM_WAVELENGTH, range.maximumW());
        if (request.terms().isPresent() || thesis) {
            int terms = request.terms().orElse(THESIS_TERMS);
            return switch (kind) {
                case TAYLOR -> new TaylorExpansion(scale, terms, maximum);
                case CHEBYSHEV -> new ChebyshevExpansion(scale, terms, maximum);
                case LOWRANK -> LowRankExpansion.ofTerms(heights, scale, minimum, maximum, terms);
            };
        }
        return switch (kind) {
            case TAYLOR -> TaylorExpansion.within(scale, maximum, EXPANSION_TOLERANCE);
            case CHEBYSHEV -> ChebyshevExpansion.within(scale, maximum, EXPANSION_TOLERANCE);
            case LOWRANK -> LowRankExpansion.within(heights, scale, minimum, maximum, EXPANSION_TOLERANCE);
        };
    }
}
