package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongConsumer;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import sunbeam.precompute.optics.DirectionPair;

/** Evaluates directions on the GPU, one fragment each (shaders/directions.frag): powers if {@code spectral}, else colors. */
public record DirectionsRenderer(RenderContext context, UploadedTables method, boolean spectral, ShaderProgram program)
        implements AutoCloseable {
    // Directions per draw: few enough for a short draw on a slow driver, enough to keep all its processors busy.
    private static final int BATCH = 256;
    // Texels of a direction, one below the other (shaders/directions.frag).
    private static final int ROWS = 4;

    public DirectionsRenderer {}

    public DirectionsRenderer(RenderContext context, UploadedTables method, boolean spectral) {
        this(
                context,
                method,
                spectral,
                method.program("directions.frag", spectral ? Map.of("SPECTRAL", "1") : Map.of()));
    }

    /** Creates a renderer that returns the method's own average as both coherent and ensemble power. */
    public static DirectionsRenderer ofOnePower(RenderContext context, UploadedTables method) {
        Map<String, String> defines = Map.of("SPECTRAL", "1", "ONE_POWER", "1");
        return new DirectionsRenderer(context, method, true, method.program("directions.frag", defines));
    }

    /** Returns coherent and ensemble power per query, or X, Y, Z of power and gain; {@code progress} gets batch sizes. */
    public List<float[]> evaluate(List<DirectionQuery> queries, LongConsumer progress) {
        List<float[]> results = new ArrayList<>(queries.size());
        try (FloatTexture texture = context.createFloatTexture(
                        "directions", FloatTexture.Spec.flat(BATCH, ROWS, FloatTexture.Format.RGBA32F));
                FloatTarget target = context.createFloatTarget("directions", FloatTarget.Spec.color(BATCH, 1))) {
            Map<String, Texture> textures = new HashMap<>(method.textures());
            textures.put("directions", texture);
            for (int start = 0; start < queries.size(); start += BATCH) {
                List<DirectionQuery> batch = queries.subList(start, Math.min(queries.size(), start + BATCH));
                texture.upload(texels(batch));
                context.drawFullScreen(program, textures, target, new Tile(0, 0, batch.size(), 1));
                float[] rgba = UploadedTables.requireWholeSums(target.read(0, new Tile(0, 0, batch.size(), 1)));
                for (int i = 0; i < batch.size(); i++) {
                    results.add(new float[] {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]});
                }
                progress.accept(batch.size());
            }
        }
        return results;
    }

    private float[] texels(List<DirectionQuery> batch) {
        float[] texels = new float[4 * ROWS * BATCH];
        for (int i = 0; i < batch.size(); i++) {
            DirectionPair pair = batch.get(i).pair();
            double wavelength = batch.get(i).wavelength();
            put(texels, i, 0, pair.wi().x(), pair.wi().y(), pair.wi().z());
            put(texels, i, 1, pair.wr().x(), pair.wr().y(), pair.wr().z());
            put(texels, i, 2, pair.u(), pair.v(), pair.w(), wavelength);
            if (spectral && method.binsPerFrequency().isPresent()) {
                double[] bins = method.binsPerFrequency().get();
                double x = pair.u() / wavelength * bins[0];
                double y = pair.v() / wavelength * bins[1];
                // The nearest DFT bin and the distance from it, in bins.
                put(texels, i, 3, Math.rint(x), Math.rint(y), x - Math.rint(x), y - Math.rint(y));
            }
        }
        return texels;
    }

    private static void put(float[] texels, int column, int row, double... values) {
        for (int i = 0; i < values.length; i++) {
            texels[4 * (row * BATCH + column) + i] = (float) values[i];
        }
    }

    @Override
    public void close() {
        program.close();
    }
}
