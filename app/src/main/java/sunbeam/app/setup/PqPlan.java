package sunbeam.app.setup;

import java.util.List;
import jrtr.RenderContext;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.DiffractionMethod;
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

/** What method {@code pq} computes for a patch and a range of directions. */
final class PqPlan {
    private static final double COARSEST_STEP = 5e-9;
    private static final double FINEST_STEP = 0.05e-9;

    private final DiffractionSetup setup;
    private final HeightMap map;
    private final PeriodInterpolation interpolation;
    private final Replicas replicas;
    private final Plan plan;
    private final WavelengthNodes wavelengths;

    PqPlan(DiffractionSetup setup, MethodRequest method, PlanRequest request, VisibleRange range) {
        this.setup = setup;
        this.map = setup.patch().heights();
        this.interpolation = method.interpolation();
        this.replicas = method.replicasOf(map, request.window());
        this.plan = setup.plan(request.orWavelengthStep(COARSEST_STEP), range);
        double planned = request.isThesis() ? COARSEST_STEP : step(range);
        this.wavelengths =
                WavelengthNodes.uniform(setup.cie(), request.wavelengthStep().orElse(planned));
    }

    /**
     * Rejects what has no meaning without a window.
     *
     * @throws UsageException naming the option
     */
    static void check(PlanRequest request) {
        if (request.average().orElse(Average.COHERENT) == Average.ENSEMBLE) {
            throw new UsageException("--average ensemble is not for --method pq, whose replicas lie at one place; leave"
                    + " it out or use --method full");
        }
        if (request.radius().isPresent() || request.anchor().isPresent()) {
            throw new UsageException(
                    "--radius and --anchor are not for --method pq, which has no neighbourhood of bins; leave them out");
        }
    }

    // As a function of 1 / lambda the power of a width a is band-limited to |u| a + |v| b cycles; one node a cycle is
    // what the trapezoid rule needs at least.
    private double step(VisibleRange range) {
        double cycles = largest(range.minimumU(), range.maximumU()) * replicas.alongX() * map.width()
                + largest(range.minimumV(), range.maximumV()) * replicas.alongY() * map.height();
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        return Math.min(COARSEST_STEP, Math.max(FINEST_STEP, shortest * shortest / Math.max(1e-9, cycles)));
    }

    private static double largest(double a, double b) {
        return Math.max(Math.abs(a), Math.abs(b));
    }

    String summary() {
        return "%d %s terms, %d x %d replicas with sharp edges, %s interpolation, %d wavelengths"
                .formatted(
                        plan.expansion().terms(),
                        plan.expansion().kind().label(),
                        replicas.alongX(),
                        replicas.alongY(),
                        interpolation.label(),
                        wavelengths.count());
    }

    List<String> reasons() {
        return List.of(
                "replicas: as asked for, or as many as come closest to the coherence length",
                "spectrum: of one period, %d samples a bin, %d taps along each axis; see docs/methods.md for its error"
                        .formatted(interpolation.oversampling(), interpolation.taps()),
                "wavelengths: as asked for, or one for each cycle of the power over 1 / lambda");
    }

    DiffractionMethod create(RenderContext context) {
        VisibleRange range = plan.range();
        int samples = interpolation.oversampling();
        PeriodSpectrum spectrum = new PeriodSpectrum(
                map,
                setup.heights(),
                plan.expansion(),
                range.bandX(samples * map.width(), interpolation.margin()),
                range.bandY(samples * map.height(), interpolation.margin()),
                interpolation);
        double halfRange = plan.expansion().scale().halfRange();
        return new PqMethod(context, spectrum, halfRange, replicas, wavelengths);
    }
}
