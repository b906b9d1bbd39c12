package sunbeam.precompute.color;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * Spectral bands at equally spaced wavelengths. Weights are triangles that end at the neighbors' wavelengths, and add up to 1.
 *
 * @param count number of bands, at least 2, at most one every 2 nm
 */
public record SpectralBands(WavelengthBand range, int count) {
    /** Number of bands in one {@link CieTable}: its three channels. */
    public static final int TOGETHER = 3;

    private static final double LEAST_STEP = 2;
    private static final double FIRST = 380;

    public SpectralBands {
        double width = range.lastNanometers() - range.firstNanometers();
        int most = 1 + (int) (width / LEAST_STEP);
        if (count < 2 || count > most) {
            throw new IllegalArgumentException(
                    count + " is out of range; " + (most < 2 ? range + " is too narrow for any" : "give 2 to " + most));
        }
    }

    /** Returns the distance of bands in nanometers. */
    public double step() {
        return (range.lastNanometers() - range.firstNanometers()) / (count - 1);
    }

    /** Returns the wavelengths in nanometers. */
    public double[] nanometers() {
        return IntStream.range(0, count)
                .mapToDouble(band -> range.firstNanometers() + band * step())
                .toArray();
    }

    /** Returns the number of tables that hold all bands. */
    public int tables() {
        return (count + TOGETHER - 1) / TOGETHER;
    }

    /** Returns the weights of the bands from {@code TOGETHER * number} on, as the channels of a table; zero beyond the last band. */
    public CieTable table(int number) {
        double[] centers = nanometers();
        double[][] weights = new double[Illuminant.LAST + 1][TOGETHER];
        for (int c = 0; c < TOGETHER; c++) {
            int band = TOGETHER * number + c;
            if (band < count) {
                double[] triangle = triangle(centers[band]);
                // The ends count half.
                double integral = DoubleStream.of(triangle).sum() - 0.5 * (triangle[0] + triangle[Illuminant.LAST]);
                for (int i = 0; i <= Illuminant.LAST; i++) {
                    weights[i][c] = triangle[i] / integral;
                }
            }
        }
        return CieTable.ofFunctions(weights, count + " bands, " + range);
    }

    private double[] triangle(double center) {
        return IntStream.rangeClosed(0, Illuminant.LAST)
                .mapToDouble(i -> FIRST + i)
                .map(at -> at < range.firstNanometers() || at > range.lastNanometers()
                        ? 0
                        : Math.max(0, 1 - Math.abs(at - center) / step()))
                .toArray();
    }
}
