package sunbeam.precompute.shader;

import sunbeam.precompute.expansion.CoefficientTable;

/** Coefficients of the expansion for shaders. */
public final class SpectrumArrays {
    private SpectrumArrays() {}

    /**
     * Defines the source of the coefficients in shaders/include/expansion.glsl.
     *
     * @param sampled whether they are an array of samples, not the closed form of Taylor's series
     * @param terms of the expansion
     */
    public static void define(ShaderTables.Builder tables, boolean sampled, int terms) {
        tables.define("EXPANSION_TAYLOR", 0).define("EXPANSION_SAMPLED", 1);
        tables.define("EXPANSION", sampled ? "EXPANSION_SAMPLED" : "EXPANSION_TAYLOR")
                .define("TERMS", terms);
    }

    /** Returns the shape of {@link #coefficients}. */
    public static ArrayLayout coefficientsLayout(String sampler, int samples, int terms, int channels) {
        return ArrayLayout.flat(sampler, samples, (terms + channels - 1) / channels, channels);
    }

    /**
     * Returns coefficients as rows of texels.
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

    /** Returns offset and scale from a phase to the fractional index of the samples. */
    public static double[] phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0) / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new double[] {-scale * coefficients.minimumPhase(), scale};
    }

    /** Returns offset and scale to the texture coordinate: the first and the last sample are texel centers. */
    public static double[] textureMap(double first, double last, int samples) {
        double scale = (samples - 1.0) / samples / (last - first);
        return new double[] {0.5 / samples - scale * first, scale};
    }
}
