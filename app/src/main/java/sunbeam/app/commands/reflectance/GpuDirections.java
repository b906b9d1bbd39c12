package sunbeam.app.commands.reflectance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** Directions by the shaders. */
final class GpuDirections {
    private final MethodPlan plan;
    private final DiffractionSetup setup;

    GpuDirections(DiffractionSetup setup, MethodPlan plan) {
        this.setup = setup;
        this.plan = plan;
    }

    /** @param trial told what was found of a table when it was tried; empty without one */
    List<double[]> evaluate(DirectionList list, Consumer<String> trial) {
        MethodUse use = list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOR;
        List<DirectionsRenderer.Query> queries = new ArrayList<>(list.size());
        for (int row = 0; row < list.size(); row++) {
            double wavelength = list.spectral() ? list.wavelength(row) : 0;
            queries.add(new DirectionsRenderer.Query(list.pair(row), wavelength));
        }
        ShaderTables tables = setup.tables(plan, use, GpuColors::of);
        trial.accept(tables.trial());
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables method = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, list.spectral());
                Progress progress = Progress.start("Directions", list.size())) {
            List<double[]> results = new ArrayList<>(list.size());
            for (float[] values : renderer.evaluate(queries, progress::step)) {
                results.add(new double[] {values[0], values[1], values[2], values[3]});
            }
            return results;
        }
    }
}
