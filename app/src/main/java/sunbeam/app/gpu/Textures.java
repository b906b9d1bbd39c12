package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import jrtr.Binding;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import org.joml.Vector2f;
import org.joml.Vector3f;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.CoefficientTable;

/** The textures of one method, by sampler name; made, bound and freed together. */
final class Textures implements AutoCloseable {
    private final RenderContext context;
    private final List<FloatTexture> textures = new ArrayList<>();
    private final List<Binding> bindings = new ArrayList<>();

    Textures(RenderContext context) {
        this.context = context;
    }

    FloatTexture add(String sampler, FloatTextureSpec spec) {
        FloatTexture texture = context.createFloatTexture(sampler, spec);
        textures.add(texture);
        bindings.add(new Binding(sampler, texture));
        return texture;
    }

    /** The CIE weights of shaders/include/spectrum.glsl, per metre of wavelength. */
    void addCieWeights(CieTable cie) {
        int samples = SmoothCieWeights.SAMPLES;
        double norm = 1 / cie.integralOfY();
        float[] texels = new float[4 * samples];
        for (int c = 0; c < 3; c++) {
            double[] weights = SmoothCieWeights.of(cie, c);
            for (int i = 0; i < samples; i++) {
                texels[4 * i + c] = (float) (weights[i] * norm);
            }
        }
        add("cieWeights", FloatTextureSpec.line(samples, FloatFormat.RGBA32F).with(Filter.LINEAR))
                .upload(texels);
    }

    /** XYZ of D65 over the band, as the texture of {@link #addCieWeights} integrates to. */
    static Vector3f cieWhite(CieTable cie) {
        double[] sums = new double[3];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < 400; i++) {
                double left = CieTable.MINIMUM_WAVELENGTH + i * 1e-9;
                sums[c] += 0.5e-9 * (cie.at(left, c) + cie.at(left + 1e-9, c));
            }
        }
        return new Vector3f((float) (sums[0] / sums[1]), 1, (float) (sums[2] / sums[1]));
    }

    /** The fixed wavelengths of shaders/include/wavelengths.glsl. */
    void addWavelengths(WavelengthNodes nodes) {
        float[] texels = new float[4 * nodes.count()];
        for (int i = 0; i < nodes.count(); i++) {
            texels[4 * i] = (float) nodes.wavelengths()[i];
            for (int c = 0; c < 3; c++) {
                texels[4 * i + 1 + c] = (float) nodes.weights()[i][c];
            }
        }
        add("wavelengthNodes", FloatTextureSpec.line(nodes.count(), FloatFormat.RGBA32F))
                .upload(texels);
    }

    /** Weights of taps by the fraction of a position, as shaders/method/grid_tables.glsl reads them. */
    void addInterpolationKernel(int samples, int taps, DoubleUnaryOperator kernel) {
        int rows = (taps + 3) / 4;
        float[] texels = new float[4 * rows * samples];
        for (int i = 0; i < samples; i++) {
            double fraction = (double) i / (samples - 1);
            for (int tap = 0; tap < taps; tap++) {
                double distance = fraction + 0.5 * taps - 1 - tap;
                texels[4 * (tap / 4 * samples + i) + tap % 4] = (float) kernel.applyAsDouble(distance);
            }
        }
        FloatTextureSpec spec = FloatTextureSpec.flat(samples, rows, FloatFormat.RGBA32F);
        add("gridKernel", spec.with(Filter.LINEAR)).upload(texels);
    }

    /** Coefficients as rows of texels with some terms each. */
    void addCoefficients(String sampler, CoefficientTable coefficients, FloatFormat format) {
        int channels = format.channels();
        int rows = (coefficients.terms() + channels - 1) / channels;
        int samples = coefficients.samples();
        float[] texels = new float[rows * samples * channels];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 0; i < samples; i++) {
                texels[((n / channels) * samples + i) * channels + n % channels] =
                        coefficients.values()[n][i];
            }
        }
        add(sampler, FloatTextureSpec.flat(samples, rows, format).with(Filter.LINEAR))
                .upload(texels);
    }

    /** Texture coordinate of a phase: the first sample lies at the first texel's centre, the last at the last's. */
    static Vector2f phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0)
                / coefficients.samples()
                / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new Vector2f(
                (float) (0.5 / coefficients.samples() - scale * coefficients.minimumPhase()), (float) scale);
    }

    List<Binding> bindings() {
        return List.copyOf(bindings);
    }

    @Override
    public void close() {
        textures.forEach(FloatTexture::close);
    }
}
