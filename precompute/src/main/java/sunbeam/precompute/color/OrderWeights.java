package sunbeam.precompute.color;

import java.util.stream.IntStream;

/**
 * Table of the color weights of diffraction orders, each of which is a Gaussian of 1 / lambda with a center s and a width:
 *
 * <pre>W(s, width) = int S xbar exp(-((1 / lambda - s) / width)^2) dlambda / int S ybar dlambda</pre>
 *
 * tabulated as W / width, which hardly depends on width where orders are narrow: sqrt(pi) lambda^2 S xbar(lambda).
 *
 * @param minimumPlace center s of the first column, 1 / meter
 * @param values {@code [(row * COLUMNS + column) * 3 + channel]}, meters
 */
public record OrderWeights(
        double minimumPlace, double maximumPlace, double minimumWidth, double maximumWidth, float[] values) {

    // The step is 0.7 nm at 500 nm; color matching functions bend over tens of nanometers.
    public static final int COLUMNS = 768;

    public static final int ROWS = 24;

    // In widths: exp(-4.5^2) = 2e-9.
    private static final double REACH = 4.5;
    // The trapezoid rule for exp(-(x / width)^2) has the relative error 2 exp(-(pi width / step)^2).
    private static final int NODES_PER_WIDTH = 4;

    /** Tabulates the weights for widths in 1 / meter. */
    public static OrderWeights tabulate(CieTable cie, double narrowest, double widest) {
        // At the first and last place the widest order just misses the band: the texture's border is black.
        double low = 1 / CieTable.MAXIMUM_WAVELENGTH - REACH * widest;
        double high = 1 / CieTable.MINIMUM_WAVELENGTH + REACH * widest;
        float[] values = new float[3 * COLUMNS * ROWS];
        IntStream.range(0, ROWS).parallel().forEach(row -> {
            double width = narrowest + (widest - narrowest) * row / (ROWS - 1);
            for (int column = 0; column < COLUMNS; column++) {
                double[] weight = integral(cie, low + (high - low) * column / (COLUMNS - 1), width);
                for (int c = 0; c < 3; c++) {
                    values[3 * (row * COLUMNS + column) + c] = (float) (weight[c] / width);
                }
            }
        });
        return new OrderWeights(low, high, narrowest, widest, values);
    }

    /** Returns W of one order for X, Y, Z, integrated over 1 / lambda: dlambda = lambda^2 d(1 / lambda). */
    static double[] integral(CieTable cie, double center, double width) {
        double step = width / NODES_PER_WIDTH;
        int reach = (int) Math.ceil(REACH * NODES_PER_WIDTH);
        double[] sum = new double[3];
        for (int i = -reach; i <= reach; i++) {
            double waveNumber = center + i * step;
            if (waveNumber > 0) {
                double wavelength = 1 / waveNumber;
                double gauss = Math.exp(-Math.pow(i * step / width, 2)) * wavelength * wavelength * step;
                for (int c = 0; c < 3; c++) {
                    sum[c] += gauss * cie.at(wavelength, c);
                }
            }
        }
        double norm = 1 / cie.integralOfY();
        return new double[] {sum[0] * norm, sum[1] * norm, sum[2] * norm};
    }
}
