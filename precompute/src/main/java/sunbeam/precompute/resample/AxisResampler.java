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
record AxisResampler(AxisGrid grid, Band band, int[] firstBin, double[][] weights) {

    /**
     * Tabulates the weights.
     *
     * @param period of the patch in metres; bin j has the frequency j / period
     * @param weight as a function of the distance in grid steps
     * @param reach distance in grid steps from which on it is zero
     */
    static AxisResampler of(AxisGrid grid, Band band, double period, DoubleUnaryOperator weight, double reach) {
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
