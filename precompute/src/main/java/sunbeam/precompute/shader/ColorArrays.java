package sunbeam.precompute.shader;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SmoothCieWeights;
import sunbeam.precompute.color.WavelengthNodes;

/** Color matching as shaders read it: weights at any wavelength, or at fixed ones. */
public final class ColorArrays {
    private ColorArrays() {}

    /** Shape of {@link #cieWeights}. */
    public static ArrayLayout cieWeightsLayout() {
        return ArrayLayout.flat("cieWeights", SmoothCieWeights.SAMPLES, 2, 4).linear();
    }

    /**
     * The CIE weights of shaders/include/spectrum.glsl, per metre of wavelength: a row of smooth ones, for integrals over
     * nanometres, and a row of the table's own, for orders that are narrower than its steps.
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

    /** Shape of {@link #wavelengths}. */
    public static ArrayLayout wavelengthsLayout(WavelengthNodes nodes) {
        return ArrayLayout.flat("wavelengthNodes", nodes.count(), 1, 4);
    }

    /** The fixed wavelengths of shaders/include/wavelengths.glsl. */
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
