package sunbeam.app.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.directions.DirectionsRenderer;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.progress.Progress;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.MethodRequest;
import sunbeam.app.setup.Methods;
import sunbeam.precompute.evaluation.BinSums;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.WindowPlace;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Geometry;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** The power over a grid, by one of the methods. */
final class Responses {
    // Directions that are handed to the GPU at once; one fragment each.
    private static final int PORTION = 1 << 14;

    private final DiffractionSetup setup;
    private final PlanRequest request;
    private final ResponseGrid grid;
    private final Consumer<MethodPlan> planned;
    private String plan;

    /** Who evaluates. */
    enum Method {
        /** Direct sums over the surface. */
        REFERENCE,
        FULL,
        NMM,
        PQ,
        /** {@link BinSums}. */
        BINS
    }

    /** @param planned told of the method that a shader uses, once it is planned */
    Responses(DiffractionSetup setup, PlanRequest request, ResponseGrid grid, Consumer<MethodPlan> planned) {
        this.setup = setup;
        this.request = request;
        this.grid = grid;
        this.planned = planned;
    }

    /** The power that the request's average means. */
    ResponseMatrix power(Method method) {
        return switch (method) {
            case REFERENCE -> reference();
            case FULL -> onGpu(MethodKind.FULL);
            case NMM -> onGpu(MethodKind.NMM);
            case PQ -> onGpu(MethodKind.PQ);
            case BINS -> bins();
        };
    }

    /** One line: the plan of the last {@link #power} on the GPU; nothing for methods without a plan. */
    Optional<String> plan() {
        return Optional.ofNullable(plan);
    }

    private boolean ensemble() {
        return request.average().orElse(Average.COHERENT) == Average.ENSEMBLE;
    }

    private ResponseMatrix reference() {
        ReferenceEvaluator evaluator =
                new ReferenceEvaluator(setup.patch().heights(), request.window(), request.windowOrigin());
        double[][] power = new double[grid.wavelengths().length][grid.angles().length];
        int columns = grid.angles().length;
        int count = power.length * columns;
        try (Progress progress = Progress.start("Reference", count)) {
            IntStream.range(0, count).parallel().forEach(i -> {
                Geometry geometry = grid.plane().geometry(grid.angles()[i % columns]);
                double wavelength = grid.wavelengths()[i / columns];
                power[i / columns][i % columns] = ensemble()
                        ? evaluator.powers(geometry, wavelength).ensemble()
                        : evaluator.coherent(geometry, wavelength);
                progress.step(1);
            });
        }
        return new ResponseMatrix(grid, power);
    }

    private ResponseMatrix bins() {
        BinSums sums = binSums();
        try (Progress progress = Progress.start("Response", grid.wavelengths().length)) {
            if (ensemble()) {
                return sums.ensemble(progress::step);
            }
            WindowPlace place = WindowPlace.of(
                    request.windowOrigin(),
                    setup.surface().identity().columns(),
                    setup.surface().identity().rows());
            return sums.coherent(List.of(place), progress::step).get(0);
        }
    }

    /** Sums over bins for any position of the window. */
    BinSums binSums() {
        return BinSums.of(setup.surface().identity(), setup.surface().levels(), request.window(), grid);
    }

    private ResponseMatrix onGpu(MethodKind kind) {
        List<Geometry> directions = new ArrayList<>(grid.angles().length);
        for (double angle : grid.angles()) {
            directions.add(grid.plane().geometry(angle));
        }
        MethodPlan method = Methods.plan(setup, MethodRequest.of(kind), request, VisibleRange.of(directions));
        plan = method.summary();
        planned.accept(method);
        ShaderTables tables = setup.tables(method, MethodUse.SPECTRAL);
        long count = (long) grid.wavelengths().length * directions.size();
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables uploaded = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, uploaded, true);
                Progress progress = Progress.start("Response", count)) {
            return new ResponseMatrix(grid, render(renderer, directions, progress));
        }
    }

    private double[][] render(DirectionsRenderer renderer, List<Geometry> directions, Progress progress) {
        int columns = directions.size();
        double[][] power = new double[grid.wavelengths().length][columns];
        int channel = ensemble() ? 1 : 0;
        int count = power.length * columns;
        for (int start = 0; start < count; start += PORTION) {
            List<DirectionsRenderer.Query> portion = new ArrayList<>(PORTION);
            for (int i = start; i < Math.min(count, start + PORTION); i++) {
                portion.add(new DirectionsRenderer.Query(directions.get(i % columns), grid.wavelengths()[i / columns]));
            }
            List<float[]> values = renderer.evaluate(portion, progress::step);
            for (int i = 0; i < values.size(); i++) {
                power[(start + i) / columns][(start + i) % columns] = values.get(i)[channel];
            }
        }
        return power;
    }
}
