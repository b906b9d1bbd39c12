package sunbeam.precompute.color;

import java.util.function.DoubleUnaryOperator;

/**
 * Quadrature nodes and weights over wavelengths: X = sum_i power(lambda_i) weightX_i, Y and Z alike, so that power 1 gives the light's
 * white with Y = 1.
 *
 * @param wavelengths nodes in meters, ascending
 * @param weights {@code [node][3]}, weights of X, Y and Z
 */
public record WavelengthNodes(double[] wavelengths, double[][] weights) {

    public int count() {
        return wavelengths.length;
    }

    /** Integrates a power, given as a function of the wavelength in meters, to X, Y, Z. */
    public double[] sum(DoubleUnaryOperator power) {
        double[] sum = new double[3];
        for (int i = 0; i < wavelengths.length; i++) {
            double value = power.applyAsDouble(wavelengths[i]);
            for (int c = 0; c < 3; c++) {
                sum[c] += value * weights[i][c];
            }
        }
        return sum;
    }

    /**
     * Returns nodes at equal steps over 380..780 nm with weights of the trapezoid rule, normalized by its sum for Y. For light with lines
     * the steps of 1 / lambda are equal and at most half as long, and the weights integrate the light exactly.
     *
     * @param stepMeters wanted step; shortened so that the band's ends are nodes
     */
    public static WavelengthNodes uniform(CieTable cie, double stepMeters) {
        if (!cie.isSmooth()) {
            double ofWaveNumber = stepMeters / (CieTable.MINIMUM_WAVELENGTH * CieTable.MINIMUM_WAVELENGTH);
            return IntegratedNodes.of(cie, 0.5 * ofWaveNumber);
        }
        double band = CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH;
        int intervals = Math.max(1, (int) Math.ceil(band / stepMeters - 1e-9));
        double[] wavelengths = new double[intervals + 1];
        double[][] weights = new double[intervals + 1][3];
        double sumY = 0;
        for (int i = 0; i <= intervals; i++) {
            wavelengths[i] = CieTable.MINIMUM_WAVELENGTH + band * i / intervals;
            double end = i == 0 || i == intervals ? 0.5 : 1;
            for (int c = 0; c < 3; c++) {
                weights[i][c] = end * cie.at(wavelengths[i], c);
            }
            sumY += weights[i][1];
        }
        for (double[] weight : weights) {
            for (int c = 0; c < 3; c++) {
                weight[c] /= sumY;
            }
        }
        return new WavelengthNodes(wavelengths, weights);
    }
}
