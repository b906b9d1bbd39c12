package sunbeam.app.gpu;

import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import org.joml.Vector2f;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.resample.PeriodSpectrum;

/** Method {@code pq}: the patch repeated Q times along each axis, with sharp edges (shaders/method/pq.glsl). */
public final class PqMethod implements DiffractionMethod {
    // Linear interpolation between so many weights of the kernel errs by less than 1e-6.
    private static final int KERNEL_SAMPLES = 1024;
    private static final int TERMS_PER_TEXEL = 2;

    private final PeriodSpectrum spectrum;
    private final Replicas replicas;
    private final WavelengthNodes wavelengths;
    private final CoefficientTable coefficients;
    private final double halfRange;
    private final Textures textures;

    /**
     * Transforms the period and uploads it.
     *
     * @param halfRange half of the relief, by which the expansion scaled the heights, metres
     * @param replicas Q along each axis
     */
    public PqMethod(
            RenderContext context,
            PeriodSpectrum spectrum,
            double halfRange,
            Replicas replicas,
            WavelengthNodes wavelengths) {
        this.spectrum = spectrum;
        this.halfRange = halfRange;
        this.replicas = replicas;
        this.wavelengths = wavelengths;
        this.coefficients = spectrum.coefficients();
        this.textures = new Textures(context);
        textures.addInterpolationKernel(
                KERNEL_SAMPLES, spectrum.interpolation().taps(), spectrum.interpolation()::kernel);
        textures.addCoefficients("periodCoefficients", coefficients, FloatFormat.RGBA32F);
        textures.addWavelengths(wavelengths);
        uploadTerms();
    }

    private int layers() {
        return (spectrum.terms() + TERMS_PER_TEXEL - 1) / TERMS_PER_TEXEL;
    }

    private void uploadTerms() {
        int width = spectrum.bandX().count();
        int height = spectrum.bandY().count();
        FloatTexture texture =
                textures.add("periodTerms", FloatTextureSpec.array(width, height, layers(), FloatFormat.RGBA32F));
        for (int layer = 0; layer < layers(); layer++) {
            float[] texels = new float[4 * width * height];
            for (int n = 0; n < TERMS_PER_TEXEL && TERMS_PER_TEXEL * layer + n < spectrum.terms(); n++) {
                ComplexVector term = spectrum.term(TERMS_PER_TEXEL * layer + n);
                for (int i = 0; i < term.length(); i++) {
                    texels[4 * i + 2 * n] = (float) term.real()[i];
                    texels[4 * i + 2 * n + 1] = (float) term.imaginary()[i];
                }
            }
            texture.uploadLayer(layer, texels);
        }
    }

    @Override
    public Map<String, String> defines() {
        Map<String, String> defines = MethodDefines.of("pq", Average.COHERENT);
        defines.put("TAPS", Integer.toString(spectrum.interpolation().taps()));
        defines.put("PERIOD_LAYERS", Integer.toString(layers()));
        return defines;
    }

    @Override
    public void setUniforms(ShaderProgram program) {
        program.set("heightHalfRange", (float) halfRange);
        program.set("periodPhaseMap", Textures.phaseMap(coefficients));
        program.set("periodScale", new Vector2f((float) spectrum.scaleX(), (float) spectrum.scaleY()));
        program.set(
                "periodFirst",
                new Vector2f(spectrum.bandX().first(), spectrum.bandY().first()));
        program.set("periodLength", new Vector2f((float) spectrum.width(), (float) spectrum.height()));
        program.set("periodReplicas", new Vector2f(replicas.alongX(), replicas.alongY()));
        program.set("wavelengthCount", wavelengths.count());
    }

    @Override
    public List<Binding> bindings() {
        return textures.bindings();
    }

    /** Of the Gaussian whose effective area, 4 pi sigma^2, is that of the replicas. */
    @Override
    public double windowSigma() {
        return replicas.equalAreaWindow(spectrum.width(), spectrum.height()).sigmaMetres();
    }

    @Override
    public void close() {
        textures.close();
    }
}
