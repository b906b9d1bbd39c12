package sunbeam.precompute.shader;

import sunbeam.precompute.expansion.CoefficientTable;

/** Coefficients of the expansion for shaders. */
public final class SpectrumArrays {
    private static final int TOGETHER = 4;

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

    /** Shape of {@link #coefficients}: a row of samples for each {@value #TOGETHER} terms. */
    public static ArrayLayout coefficientsLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, (terms + TOGETHER - 1) / TOGETHER, TOGETHER);
    }

    /** Coefficients of {@value #TOGETHER} terms a texel, for shaders that add up terms in their order. */
    public static TableArray coefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = coefficientsLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 0; i < samples; i++) {
                texels[((n / TOGETHER) * samples + i) * TOGETHER + n % TOGETHER] =
                        coefficients.values()[n][i];
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Shape of {@link #singleCoefficients}: a row of samples for each term. */
    public static ArrayLayout singleLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, terms, TOGETHER);
    }

    /** Coefficients of one term a texel, each sample between its neighbors: a shader that needs single terms fetches once. */
    public static TableArray singleCoefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = singleLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 1; i < samples - 1; i++) {
                System.arraycopy(coefficients.values()[n], i - 1, texels, (n * samples + i) * TOGETHER, 3);
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Offset and scale from a phase to the place among its coefficients' samples, counted from 0. */
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
