package sunbeam.precompute.shader;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SmoothCieWeights;
import sunbeam.precompute.color.WavelengthNodes;

/** CIE weights (color matching functions times the light's spectrum) for shaders: at any wavelength, or at fixed ones. */
public final class ColorArrays {
    private ColorArrays() {}

    public static ArrayLayout cieWeightsLayout() {
        return ArrayLayout.flat("cieWeights", SmoothCieWeights.SAMPLES, 2, 4).linear();
    }

    /**
     * Returns the CIE weights of shaders/include/spectrum.glsl, per meter of wavelength: row 0 is smoothed, for integrals over several
     * nanometers; row 1 has the table's own values, for narrower orders.
     */
    public static TableArray cieWeights(CieTable cie) {
        int samples = SmoothCieWeights.SAMPLES;
        double norm = 1 / cie.integralOfY();
        float[] texels = new float[2 * 4 * samples];
        for (int c = 0; c < 3; c++) {
            double[] weights = SmoothCieWeights.of(cie, c);
            for (int i = 0; i < samples; i++) {
                texels[4 * i + c] = (float) (weights[i] * norm);
                texels[4 * (samples + i) + c] = (float) (cie.at(SmoothCieWeights.wavelength(i), c) * norm);
            }
        }
        return TableArray.of(cieWeightsLayout(), texels);
    }

    public static ArrayLayout wavelengthsLayout(WavelengthNodes nodes) {
        return ArrayLayout.flat("wavelengthNodes", nodes.count(), 1, 4);
    }

    /** Returns the fixed wavelengths and their weights, for shaders/include/wavelengths.glsl. */
    public static TableArray wavelengths(WavelengthNodes nodes) {
        float[] texels = new float[4 * nodes.count()];
        for (int i = 0; i < nodes.count(); i++) {
            texels[4 * i] = (float) nodes.wavelengths()[i];
            for (int c = 0; c < 3; c++) {
                texels[4 * i + 1 + c] = (float) nodes.weights()[i][c];
            }
        }
        return TableArray.of(wavelengthsLayout(nodes), texels);
    }
}
