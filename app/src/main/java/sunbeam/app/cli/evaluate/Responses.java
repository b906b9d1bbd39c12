package sunbeam.app.cli.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuBaker;
import sunbeam.app.terminal.Progress;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;

/** Computes the diffracted power over a grid of wavelengths and angles, under the method's average. */
final class Responses {
    private Responses() {}

    static ResponseMatrix exact(DiffractionSetup setup, Method method, ResponseGrid grid) {
        ExactLight light = setup.exact(method);
        List<DirectionPair> pairs = grid.pairs();
        int columns = pairs.size();
        double[][] power = new double[grid.wavelengths().length][columns];
        int count = power.length * columns;
        try (Progress progress = setup.progress().start("Reference", count)) {
            IntStream.range(0, count).parallel().forEach(i -> {
                power[i / columns][i % columns] = light.power(pairs.get(i % columns), grid.wavelengths()[i / columns]);
                progress.step(1);
            });
        }
        return new ResponseMatrix(grid, power);
    }

    /** Evaluates by the shader that also draws BRDF maps, with a fragment for each direction and wavelength. */
    static ResponseMatrix byShader(DiffractionSetup setup, MethodPlan plan, ResponseGrid grid) {
        ShaderTables tables = setup.tables(plan, MethodUse.SPECTRAL, GpuBaker::of);
        double[] wavelengths = grid.wavelengths();
        double[][] power = new double[wavelengths.length][];
        try (RenderContext context = RenderContext.offscreen();
                UploadedTables uploaded = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = DirectionsRenderer.ofOnePower(context, uploaded);
                Progress progress =
                        setup.progress().start("Response", (long) wavelengths.length * grid.angles().length)) {
            for (int row = 0; row < wavelengths.length; row++) {
                List<DirectionsRenderer.Query> queries = new ArrayList<>();
                for (DirectionPair pair : grid.pairs()) {
                    queries.add(new DirectionsRenderer.Query(pair, wavelengths[row]));
                }
                power[row] = renderer.evaluate(queries, progress::step).stream()
                        .mapToDouble(values -> values[0])
                        .toArray();
            }
        }
        return new ResponseMatrix(grid, power);
    }
}
