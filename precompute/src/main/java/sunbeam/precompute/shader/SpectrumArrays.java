package sunbeam.precompute.shader;

import sunbeam.precompute.expansion.CoefficientTable;

public final class SpectrumArrays {
    private static final int PER_TEXEL = 4;

    private SpectrumArrays() {}

    /** Defines the source of coefficients in shaders/include/expansion.glsl: an array of samples, or the closed form of Taylor. */
    public static void define(ShaderTables.Builder tables, boolean sampled, int terms) {
        tables.define("EXPANSION_TAYLOR", 0).define("EXPANSION_SAMPLED", 1);
        tables.define("EXPANSION", sampled ? "EXPANSION_SAMPLED" : "EXPANSION_TAYLOR")
                .define("TERMS", terms);
    }

    public static ArrayLayout coefficientsLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, (terms + PER_TEXEL - 1) / PER_TEXEL, PER_TEXEL);
    }

    /** Each texel has {@value #PER_TEXEL} terms, for shaders that sum all terms in order. */
    public static TableArray coefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = coefficientsLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 0; i < samples; i++) {
                texels[((n / PER_TEXEL) * samples + i) * PER_TEXEL + n % PER_TEXEL] =
                        (float) coefficients.values()[i][n];
            }
        }
        return TableArray.of(layout, texels);
    }

    public static ArrayLayout singleLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, terms, PER_TEXEL);
    }

    /** Each texel has a term's coefficient at the previous, this and the next sample, so that one texel fetch interpolates it. */
    public static TableArray singleCoefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = singleLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            float[] floats = coefficients.floats(n);
            for (int i = 1; i < samples - 1; i++) {
                System.arraycopy(floats, i - 1, texels, (n * samples + i) * PER_TEXEL, 3);
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Returns {offset, scale}: a phase in radians belongs to sample offset + scale times phase, counted from 0. */
    public static double[] phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0) / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new double[] {-scale * coefficients.minimumPhase(), scale};
    }

    /** Returns {offset, scale} of the map from a value to its texture coordinate. */
    public static double[] textureMap(double first, double last, int samples) {
        double scale = (samples - 1.0) / samples / (last - first);
        return new double[] {0.5 / samples - scale * first, scale};
    }
}
