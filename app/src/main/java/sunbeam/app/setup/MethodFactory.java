package sunbeam.app.setup;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.SPACING;

import java.util.List;
import java.util.Optional;
import jrtr.RenderContext;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.FullMethod;
import sunbeam.app.gpu.GemMethod;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.gpu.NmmMethod;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.units.Lengths;

/** The method that a user asks for, planned for a patch and the directions that can occur, and then made. */
public final class MethodFactory {
    // Beyond, a patch is no single period of a grating whose colours can be seen.
    private static final double WIDEST_PERIOD = 10e-6;

    private final DiffractionSetup setup;
    private final MethodRequest method;
    private final PlanRequest request;
    private final Plan plan;
    private final PqPlan pqPlan;

    /** As the other constructor. */
    public MethodFactory(DiffractionSetup setup, Method method, VisibleRange range) {
        this(setup, MethodBridge.methodRequest(method), MethodBridge.planRequest(method), range);
    }

    /**
     * Checks that the method can do what is asked for, and plans it.
     *
     * @param range directions that can occur
     * @throws UsageException when it cannot
     */
    public MethodFactory(DiffractionSetup setup, MethodRequest method, PlanRequest request, VisibleRange range) {
        this.setup = setup;
        this.method = method;
        this.request = request;
        check();
        boolean nmm = method.kind() == MethodKind.NMM;
        PlanRequest planned = nmm ? request.orWavelengthStep(NmmMethod.WAVELENGTH_STEP) : request;
        this.plan = nmm || method.kind() == MethodKind.FULL ? setup.plan(planned, range) : null;
        this.pqPlan = method.kind() == MethodKind.PQ ? new PqPlan(setup, method, request, range) : null;
    }

    private void check() {
        switch (method.kind()) {
            case REFERENCE ->
                throw new UsageException("--method reference evaluates single directions; use it with 'reflectance'");
            case NMM -> checkNmm();
            case PQ -> PqPlan.check(request);
            case GEM -> spacing();
            case FULL -> {
                // Any patch will do.
            }
        }
    }

    private void checkNmm() {
        HeightMap map = setup.patch().heights();
        double largestUv = 2;
        if (largestUv * Math.max(map.width(), map.height()) < CieTable.MINIMUM_WAVELENGTH) {
            throw new SettingException(
                    METHOD,
                    "has nothing to go by: a patch of %s x %s has no DFT bin beside the specular one in the visible band; use "
                            .formatted(Lengths.format(map.width()), Lengths.format(map.height())),
                    METHOD,
                    " full");
        }
    }

    private double spacing() {
        double width = setup.patch().heights().width();
        if (method.spacing().isEmpty() && width > WIDEST_PERIOD) {
            throw new SettingException(
                    SPACING,
                    "is missing: a patch that is " + Lengths.format(width)
                            + " wide is no single period; give the grating's, for example ",
                    SPACING,
                    " 1um");
        }
        return method.spacing().orElse(width);
    }

    /** The plan of the Fourier table, for methods that have one. */
    public Optional<Plan> plan() {
        return Optional.ofNullable(plan);
    }

    /** One line: what is computed. */
    public String summary() {
        return switch (method.kind()) {
            case PQ -> method.kind().label() + ": " + pqPlan.summary();
            case GEM -> "gem: lines " + Lengths.format(spacing()) + " apart, for comparison only";
            case NMM ->
                "nmm: one wavelength per order" + (request.isThesis() ? ", unweighted" : "") + "; near the specular"
                        + " direction " + new PlanReport(plan).summary();
            default -> new PlanReport(plan).summary();
        };
    }

    /** What breaks the tolerance, one line each. */
    public List<Sentence> warnings() {
        return method.kind() == MethodKind.FULL ? setup.warnings(plan) : List.of();
    }

    /** Several lines: each choice and its reason. */
    public List<String> reasons() {
        if (plan != null) {
            return new PlanReport(plan).reasons();
        }
        return pqPlan != null ? pqPlan.reasons() : List.of("nothing of the surface is used");
    }

    /**
     * Makes the method with its table from the cache; the caller closes it.
     *
     * @throws UsageException when the method has no answer for the use
     */
    public DiffractionMethod create(RenderContext context, MethodUse use) {
        return create(context, use, plan().map(setup::table));
    }

    /**
     * Makes the method; the caller closes it.
     *
     * @param table made for {@link #plan()}, where there is one
     * @throws UsageException when the method has no answer for the use
     */
    public DiffractionMethod create(RenderContext context, MethodUse use, Optional<FourierTable> table) {
        return switch (method.kind()) {
            case FULL -> FullMethod.create(context, plan, table.orElseThrow(), use, setup.cie());
            case NMM -> new NmmMethod(context, plan, table.orElseThrow(), setup.cie(), !request.isThesis());
            case PQ -> pqPlan.create(context);
            case GEM -> gem(use);
            case REFERENCE -> throw new IllegalStateException("rejected before");
        };
    }

    private DiffractionMethod gem(MethodUse use) {
        if (use == MethodUse.SPECTRAL) {
            throw new UsageException("--method gem has colours, but no power at a wavelength; leave out the column"
                    + " wavelength, or use another method");
        }
        return new GemMethod(spacing(), request.window().sigmaMetres());
    }
}
