package sunbeam.app.gpu;

import java.util.Map;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.ShaderProgram;
import org.joml.Vector2f;
import org.joml.Vector4f;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.resample.AxisGrid;
import sunbeam.precompute.resample.AxisResampler;
import sunbeam.precompute.resample.Fields;
import sunbeam.precompute.resample.GridResampler;
import sunbeam.precompute.table.FourierTable;

/** Resampled spectra of one average as textures (shaders/method/grid_tables.glsl). */
final class GridTextures {
    private static final int CHANNELS = 4;

    private final String name;
    private final Plan plan;
    private final Sampling.Grid sampling;
    private final FourierTable table;
    private final Fields fields;
    private final CoefficientTable coefficients;
    private final double sigma;
    private final double step;
    private AxisGrid pointX;
    private AxisGrid pointY;
    private Vector4f raysFirst = new Vector4f();

    /**
     * Describes what is resampled.
     *
     * @param name prefix of the samplers: coherent or ensemble
     * @param sigma standard deviation of the Gaussian that windows the fields, cycles per metre
     */
    GridTextures(String name, Plan plan, Sampling.Grid sampling, FourierTable table, Fields fields, double sigma) {
        this.name = name;
        this.plan = plan;
        this.sampling = sampling;
        this.table = table;
        this.fields = fields;
        this.coefficients = fields.coefficients();
        this.sigma = sigma;
        this.step = sigma / sampling.interpolation().deviation();
    }

    int layers() {
        return (fields.count() + CHANNELS - 1) / CHANNELS;
    }

    void addCoefficients(Textures textures) {
        textures.addCoefficients(name + "Coefficients", coefficients, FloatFormat.RGBA32F);
    }

    /** The grid on which both axes are interpolated. */
    void addPoint(Textures textures, VisibleRange range) {
        pointX = range.gridX(step, taps());
        pointY = range.gridY(step, taps());
        GridResampler resampler = new GridResampler(
                AxisResampler.forInterpolation(
                        pointX, table.bandX(), table.patch().width(), sampling.interpolation()),
                AxisResampler.forInterpolation(
                        pointY, table.bandY(), table.patch().height(), sampling.interpolation()));
        FloatTexture texture = textures.add(
                name + "Point", FloatTextureSpec.array(pointX.count(), pointY.count(), layers(), FloatFormat.RGBA32F));
        upload(texture, 0, resampler, false);
    }

    /** The grids whose columns (along x) and rows (along y) the rays cross; the latter transposed. */
    void addRays(Textures textures) {
        VisibleRange range = plan.range();
        AxisGrid nodesX = range.gridX(sampling.nodeStep(), 1);
        AxisGrid nodesY = range.gridY(sampling.nodeStep(), 1);
        AxisGrid samplesX = range.gridX(step, taps());
        AxisGrid samplesY = range.gridY(step, taps());
        int width = Math.max(nodesX.count(), nodesY.count());
        int height = Math.max(samplesX.count(), samplesY.count());
        FloatTexture texture =
                textures.add(name + "Rays", FloatTextureSpec.array(width, height, 2 * layers(), FloatFormat.RGBA32F));
        double patchWidth = table.patch().width();
        double patchHeight = table.patch().height();
        GridResampler columns = new GridResampler(
                AxisResampler.exact(nodesX.extended(width), table.bandX(), patchWidth, sigma),
                AxisResampler.forInterpolation(
                        samplesY.extended(height), table.bandY(), patchHeight, sampling.interpolation()));
        GridResampler rows = new GridResampler(
                AxisResampler.forInterpolation(
                        samplesX.extended(height), table.bandX(), patchWidth, sampling.interpolation()),
                AxisResampler.exact(nodesY.extended(width), table.bandY(), patchHeight, sigma));
        upload(texture, 0, columns, false);
        upload(texture, layers(), rows, true);
        raysFirst = new Vector4f(nodesX.first(), samplesY.first(), nodesY.first(), samplesX.first());
    }

    private int taps() {
        return sampling.interpolation().taps();
    }

    private void upload(FloatTexture texture, int firstLayer, GridResampler resampler, boolean transposed) {
        for (int layer = 0; layer < layers(); layer++) {
            float[] texels = new float[CHANNELS * resampler.size()];
            for (int channel = 0; channel < CHANNELS; channel++) {
                int field = CHANNELS * layer + channel;
                if (field < fields.count()) {
                    resampler.resample(fields.field(field), texels, channel, CHANNELS, transposed);
                }
            }
            texture.uploadLayer(firstLayer + layer, texels);
        }
    }

    void define(Map<String, String> defines, String layersName) {
        defines.put(layersName, Integer.toString(layers()));
    }

    void setUniforms(ShaderProgram program) {
        program.set(name + "PhaseMap", Textures.phaseMap(coefficients));
        program.set(name + "Scale", (float) (1 / step));
        program.set(name + "PointFirst", new Vector2f(pointX.first(), pointY.first()));
    }

    /** Uniforms of the rays, where {@link #addRays} was called. */
    void setRayUniforms(ShaderProgram program) {
        program.set("gridRayScale", (float) (1 / step));
        program.set("gridRaysFirst", raysFirst);
    }
}
