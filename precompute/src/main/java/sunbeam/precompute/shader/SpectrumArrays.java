package sunbeam.precompute.shader;

import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.expansion.CoefficientTable;

/** What shaders need to interpolate spectra: taps' weights, and the expansion's coefficients. */
public final class SpectrumArrays {
    /** Linear interpolation between so many weights of a kernel errs by less than 1e-6. */
    public static final int FEW_KERNEL_SAMPLES = 1024;

    /**
     * Errs by 4e-9. On the skirt of a bright order, the outermost tap meets a sample that is a thousand times brighter than
     * what it is for.
     */
    public static final int MANY_KERNEL_SAMPLES = 16384;

    private SpectrumArrays() {}

    /** Shape of {@link #kernel}. */
    public static ArrayLayout kernelLayout(int taps, int samples) {
        return ArrayLayout.flat("gridKernel", samples, (taps + 3) / 4, 4).linear();
    }

    /**
     * Weights of taps by the fraction of a position, as shaders/method/grid_tables.glsl reads them.
     *
     * @param kernel weight of a sample by its distance in samples
     */
    public static TableArray kernel(int taps, DoubleUnaryOperator kernel, int samples) {
        ArrayLayout layout = kernelLayout(taps, samples);
        float[] texels = new float[layout.floatsPerLayer()];
        for (int i = 0; i < samples; i++) {
            double fraction = (double) i / (samples - 1);
            for (int tap = 0; tap < taps; tap++) {
                double distance = fraction + 0.5 * taps - 1 - tap;
                texels[4 * (tap / 4 * samples + i) + tap % 4] = (float) kernel.applyAsDouble(distance);
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Shape of {@link #coefficients}. */
    public static ArrayLayout coefficientsLayout(String sampler, int samples, int terms, int channels) {
        return ArrayLayout.flat(sampler, samples, (terms + channels - 1) / channels, channels)
                .linear();
    }

    /**
     * Coefficients as rows of texels with some terms each.
     *
     * @param channels terms per texel
     */
    public static TableArray coefficients(String sampler, CoefficientTable coefficients, int channels) {
        int samples = coefficients.samples();
        ArrayLayout layout = coefficientsLayout(sampler, samples, coefficients.terms(), channels);
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 0; i < samples; i++) {
                texels[((n / channels) * samples + i) * channels + n % channels] =
                        coefficients.values()[n][i];
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Offset and scale from a phase to the place among its coefficients' samples, counted from 0. */
    public static double[] phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0) / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new double[] {-scale * coefficients.minimumPhase(), scale};
    }

    /** Offset and scale to the texture coordinate: the first and the last sample lie at texels' centres. */
    public static double[] textureMap(double first, double last, int samples) {
        double scale = (samples - 1.0) / samples / (last - first);
        return new double[] {0.5 / samples - scale * first, scale};
    }
}
