package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.evaluation.BinSums;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.WindowPlace;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** The power over a grid, by one of the methods. */
final class Responses {
    // Directions that are handed to the GPU at once; one fragment each.
    private static final int PORTION = 1 << 14;
    // Of the first two portions; the second tells how long all of them take.
    private static final int FIRST = 1 << 10;
    private static final double LONG_MINUTES = 3;
    private static final int PER_CENT = 100;

    private final DiffractionSetup setup;
    private final ResponseMethod by;
    private final Method method;
    private final GaussianArea area;
    private final ResponseGrid grid;
    private final Consumer<MethodPlan> planned;
    private final Consumer<String> remark;
    private String plan;

    /**
     * @param choices that suit the method
     * @param planned told of the method that a shader uses, once it is planned
     * @param remark told how long it takes where that is long
     */
    Responses(
            DiffractionSetup setup,
            ResponseMethod by,
            Choices choices,
            ResponseGrid grid,
            Consumer<MethodPlan> planned,
            Consumer<String> remark) {
        this.setup = setup;
        this.by = by;
        this.method = by.of(choices);
        this.area = GaussianArea.of(choices);
        this.grid = grid;
        this.planned = planned;
        this.remark = remark;
    }

    /** The power that the chosen average means. */
    ResponseMatrix power() {
        return switch (by) {
            case REFERENCE -> reference();
            case FULL, NMM, PQ -> onGpu();
            case BINS -> bins();
        };
    }

    /** One line: the plan of the last {@link #power} on the GPU; nothing for methods without a plan. */
    Optional<String> plan() {
        return Optional.ofNullable(plan);
    }

    private boolean ensemble() {
        return area.average() == Average.ENSEMBLE;
    }

    private ResponseMatrix reference() {
        ReferenceEvaluator evaluator = new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin());
        double[][] power = new double[grid.wavelengths().length][grid.angles().length];
        int columns = grid.angles().length;
        int count = power.length * columns;
        try (Progress progress = Progress.start("Reference", count)) {
            IntStream.range(0, count).parallel().forEach(i -> {
                DirectionPair pair = grid.plane().pair(grid.angles()[i % columns]);
                double wavelength = grid.wavelengths()[i / columns];
                power[i / columns][i % columns] = ensemble()
                        ? evaluator.powers(pair, wavelength).ensemble()
                        : evaluator.coherent(pair, wavelength);
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
                    area.origin(),
                    setup.surface().identity().columns(),
                    setup.surface().identity().rows());
            return sums.coherent(List.of(place), progress::step).get(0);
        }
    }

    /** Sums over bins for any position of the window. */
    BinSums binSums() {
        String name = setup.surface().identity().name();
        try (Progress progress = Progress.start("Fourier tables of " + name, PER_CENT)) {
            int[] done = {0};
            return BinSums.of(setup.surface().identity(), setup.surface().levels(), area.window(), grid, share -> {
                int now = (int) (PER_CENT * share);
                progress.step(now - done[0]);
                done[0] = now;
            });
        }
    }

    private ResponseMatrix onGpu() {
        List<DirectionPair> directions = new ArrayList<>(grid.angles().length);
        for (double angle : grid.angles()) {
            directions.add(grid.plane().pair(angle));
        }
        MethodPlan made = method.plan(setup.surface(), VisibleRange.of(directions));
        plan = made.summary();
        planned.accept(made);
        ShaderTables tables = setup.tables(made, MethodUse.SPECTRAL, GpuColors::of);
        long count = (long) grid.wavelengths().length * directions.size();
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables uploaded = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = DirectionsRenderer.ofOnePower(context, uploaded);
                Progress progress = Progress.start("Response", count)) {
            return new ResponseMatrix(grid, render(renderer, directions, progress));
        }
    }

    private void tell(double minutes) {
        if (minutes > LONG_MINUTES) {
            remark.accept(String.format(
                    Locale.ROOT,
                    "the response takes about %.0f min at the speed of its first directions; larger steps of --wavelengths, fewer --angles or a --crop take less",
                    minutes));
        }
    }

    private double[][] render(DirectionsRenderer renderer, List<DirectionPair> directions, Progress progress) {
        int columns = directions.size();
        double[][] power = new double[grid.wavelengths().length][columns];
        int channel = ensemble() ? 1 : 0;
        int count = power.length * columns;
        int end;
        for (int start = 0; start < count; start = end) {
            long portionBegan = System.nanoTime();
            end = Math.min(count, start + (start <= FIRST ? FIRST : PORTION));
            List<DirectionsRenderer.Query> portion = new ArrayList<>(end - start);
            for (int i = start; i < end; i++) {
                portion.add(new DirectionsRenderer.Query(directions.get(i % columns), grid.wavelengths()[i / columns]));
            }
            List<float[]> values = renderer.evaluate(portion, progress::step);
            for (int i = 0; i < values.size(); i++) {
                power[(start + i) / columns][(start + i) % columns] = values.get(i)[channel];
            }
            // The driver compiles with the first ones.
            if (start == FIRST) {
                tell((System.nanoTime() - portionBegan) * 1e-9 * (count - end) / (end - start) / 60);
            }
        }
        return power;
    }
}
