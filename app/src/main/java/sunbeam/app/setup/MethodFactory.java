package sunbeam.app.setup;

import jrtr.RenderContext;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.FullMethod;
import sunbeam.app.gpu.GemMethod;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.gpu.NmmMethod;
import sunbeam.app.gpu.PqMethod;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.resample.PeriodSpectrum;
import sunbeam.precompute.units.Lengths;

/** Makes the method that a user asks for, for a patch and the directions that can occur. */
public final class MethodFactory {
    // Beyond, a patch is no single period of a grating whose colours can be seen.
    private static final double WIDEST_PERIOD = 10e-6;
    private static final double COARSEST_STEP = 5e-9;
    private static final double FINEST_STEP = 0.05e-9;

    private final DiffractionSetup setup;
    private final MethodRequest method;
    private final PlanRequest request;

    /**
     * Checks that the method can do what is asked for.
     *
     * @throws UsageException when it cannot
     */
    public MethodFactory(DiffractionSetup setup, MethodRequest method, PlanRequest request) {
        this.setup = setup;
        this.method = method;
        this.request = request;
        switch (method.kind()) {
            case PQ -> checkPq();
            case NMM -> checkNmm();
            case GEM -> spacing();
            default -> {
                // Nothing that the plan does not check.
            }
        }
    }

    private void checkPq() {
        if (request.average().orElse(Average.COHERENT) == Average.ENSEMBLE) {
            throw new UsageException("--average ensemble is not for --method pq, whose replicas lie at one place; leave"
                    + " it out or use --method full");
        }
        if (request.radius().isPresent() || request.anchor().isPresent()) {
            throw new UsageException(
                    "--radius and --anchor are not for --method pq, which has no neighbourhood of bins; leave them out");
        }
    }

    private void checkNmm() {
        HeightMap map = setup.patch().heights();
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double largestUv = 2;
        if (largestUv * Math.max(map.width(), map.height()) < shortest) {
            throw new UsageException("--method nmm: a patch of %s x %s has no DFT bin beside the specular one in the"
                            .formatted(Lengths.format(map.width()), Lengths.format(map.height()))
                    + " visible band; use --method full");
        }
    }

    /**
     * Makes the method; the caller closes it.
     *
     * @param range directions that can occur
     * @throws UsageException when the method does not run on the GPU, or has no answer for the use
     */
    public DiffractionMethod create(RenderContext context, VisibleRange range, MethodUse use) {
        return switch (method.kind()) {
            case REFERENCE ->
                throw new UsageException("--method reference evaluates single directions; use it with 'reflectance'");
            case FULL -> full(context, range, use);
            case NMM -> nmm(context, range);
            case PQ -> pq(context, range);
            case GEM -> gem(use);
        };
    }

    private DiffractionMethod full(RenderContext context, VisibleRange range, MethodUse use) {
        Plan plan = setup.plan(request, range);
        return FullMethod.create(context, plan, setup.table(plan), use, setup.cie());
    }

    private DiffractionMethod nmm(RenderContext context, VisibleRange range) {
        Plan plan = setup.plan(request.orWavelengthStep(NmmMethod.WAVELENGTH_STEP), range);
        return new NmmMethod(context, plan, setup.table(plan), setup.cie(), !request.isThesis());
    }

    private DiffractionMethod pq(RenderContext context, VisibleRange range) {
        HeightMap map = setup.patch().heights();
        PeriodInterpolation interpolation = method.interpolation();
        int samples = interpolation.oversampling();
        Replicas replicas = method.replicasOf(map, request.window());
        Plan plan = setup.plan(request.orWavelengthStep(COARSEST_STEP), range);
        PeriodSpectrum spectrum = new PeriodSpectrum(
                map,
                setup.heights(),
                plan.expansion(),
                range.bandX(samples * map.width(), interpolation.margin()),
                range.bandY(samples * map.height(), interpolation.margin()),
                interpolation);
        double step = request.wavelengthStep().orElse(request.isThesis() ? COARSEST_STEP : step(map, replicas, range));
        return new PqMethod(
                context,
                spectrum,
                plan.expansion().scale().halfRange(),
                replicas,
                WavelengthNodes.uniform(setup.cie(), step));
    }

    // As a function of 1 / lambda the power of a width a is band-limited to |u| a + |v| b cycles; one node a cycle is
    // what the trapezoid rule needs at least.
    private static double step(HeightMap map, Replicas replicas, VisibleRange range) {
        double cycles = largest(range.minimumU(), range.maximumU()) * replicas.alongX() * map.width()
                + largest(range.minimumV(), range.maximumV()) * replicas.alongY() * map.height();
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        return Math.min(COARSEST_STEP, Math.max(FINEST_STEP, shortest * shortest / Math.max(1e-9, cycles)));
    }

    private static double largest(double a, double b) {
        return Math.max(Math.abs(a), Math.abs(b));
    }

    private DiffractionMethod gem(MethodUse use) {
        if (use == MethodUse.SPECTRAL) {
            throw new UsageException("--method gem has colours, but no power at a wavelength; leave out the column"
                    + " wavelength, or use another method");
        }
        return new GemMethod(spacing(), request.window().sigmaMetres());
    }

    private double spacing() {
        double width = setup.patch().heights().width();
        if (method.spacing().isEmpty() && width > WIDEST_PERIOD) {
            throw new UsageException("--method gem needs --spacing: a patch that is " + Lengths.format(width)
                    + " wide is no single period; give the grating's, for example --spacing 1um");
        }
        return method.spacing().orElse(width);
    }
}
