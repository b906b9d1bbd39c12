package sunbeam.precompute.resample;

import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.fourier.Band;

/**
 * Weights from the DFT bins of one axis to the samples of a grid: sample i is sum_j weight(f_i - f_j) bin_j over the bins
 * within reach.
 *
 * @param grid the samples
 * @param band the bins
 * @param firstBin for each sample, index into the band of the first bin within reach
 * @param weights for each sample, weights of the bins from there on
 */
public record AxisResampler(AxisGrid grid, Band band, int[] firstBin, double[][] weights) {

    /** Returns weights for samples to interpolate: the Gaussian with the interpolation kernel divided out. */
    public static AxisResampler forInterpolation(AxisGrid grid, Band band, double period, InterpolationDesign design) {
        Spread spread = design.spread();
        return of(grid, band, period, spread::value, spread.reach());
    }

    /**
     * Returns weights of the plain Gaussian, for samples read at grid points only.
     *
     * @param sigma standard deviation of the Gaussian, cycles per meter
     */
    public static AxisResampler exact(AxisGrid grid, Band band, double period, double sigma) {
        double deviation = sigma / grid.step();
        return of(
                grid,
                band,
                period,
                distance -> Math.exp(-0.5 * Math.pow(distance / deviation, 2)),
                Spread.GAUSS_REACH * deviation);
    }

    private static AxisResampler of(AxisGrid grid, Band band, double period, DoubleUnaryOperator weight, double reach) {
        int[] firstBin = new int[grid.count()];
        double[][] weights = new double[grid.count()][];
        double stepsPerBin = 1 / (period * grid.step());
        for (int i = 0; i < grid.count(); i++) {
            double position = (grid.first() + i) / stepsPerBin;
            int low = (int) Math.max(band.first(), Math.ceil(position - reach / stepsPerBin));
            int high = (int) Math.min(band.last(), Math.floor(position + reach / stepsPerBin));
            firstBin[i] = low - band.first();
            weights[i] = new double[Math.max(0, high - low + 1)];
            for (int j = 0; j < weights[i].length; j++) {
                weights[i][j] = weight.applyAsDouble((position - low - j) * stepsPerBin);
            }
        }
        return new AxisResampler(grid, band, firstBin, weights);
    }
}
