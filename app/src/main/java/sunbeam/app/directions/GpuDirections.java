package sunbeam.app.directions;

import java.util.ArrayList;
import java.util.List;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.progress.Progress;
import sunbeam.app.setup.MethodFactory;

/** Directions by the shaders. */
final class GpuDirections {
    private final MethodFactory factory;

    GpuDirections(MethodFactory factory) {
        this.factory = factory;
    }

    List<double[]> evaluate(DirectionList list) {
        MethodUse use = list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOUR;
        List<DirectionsRenderer.Query> queries = new ArrayList<>(list.size());
        for (int row = 0; row < list.size(); row++) {
            double wavelength = list.spectral() ? list.wavelength(row) : 0;
            queries.add(new DirectionsRenderer.Query(list.pair(row), wavelength));
        }
        try (RenderContext context = RenderContexts.offscreen();
                DiffractionMethod method = factory.create(context, use);
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
