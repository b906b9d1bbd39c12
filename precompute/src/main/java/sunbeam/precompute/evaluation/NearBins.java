package sunbeam.precompute.evaluation;

import java.util.Arrays;
import sunbeam.precompute.table.FourierTable;

/** The bins F_j around one frequency, first accumulated term by term, then summed under the Gaussian. Not shared. */
final class NearBins {
    private final FourierTable table;
    private final BinAxis alongX;
    private final BinAxis alongY;
    private final double[] weightsX;
    private final double[] weightsY;
    private final double[] real;
    private final double[] imaginary;
    private int firstColumn;
    private int firstRow;

    NearBins(FourierTable table, BinAxis alongX, BinAxis alongY) {
        this.table = table;
        this.alongX = alongX;
        this.alongY = alongY;
        this.weightsX = new double[alongX.count()];
        this.weightsY = new double[alongY.count()];
        this.real = new double[alongX.count() * alongY.count()];
        this.imaginary = new double[real.length];
    }

    /** Clears the bins and moves to a frequency in cycles per metre. */
    void moveTo(double frequencyX, double frequencyY) {
        Arrays.fill(real, 0);
        Arrays.fill(imaginary, 0);
        alongX.weigh(frequencyX, weightsX);
        alongY.weigh(frequencyY, weightsY);
        firstColumn =
                alongX.nearest(frequencyX) - alongX.radius() - table.bandX().first();
        firstRow = alongY.nearest(frequencyY) - alongY.radius() - table.bandY().first();
    }

    /** Adds a term times a complex factor. */
    void add(int term, double factorReal, double factorImaginary) {
        float[] termReal = table.real()[term];
        float[] termImaginary = table.imaginary()[term];
        int width = weightsX.length;
        for (int row = 0; row < weightsY.length; row++) {
            int source = (firstRow + row) * table.bandX().count() + firstColumn;
            int target = row * width;
            for (int i = 0; i < width; i++) {
                double a = termReal[source + i];
                double b = termImaginary[source + i];
                real[target + i] += a * factorReal - b * factorImaginary;
                imaginary[target + i] += a * factorImaginary + b * factorReal;
            }
        }
    }

    /** sum_j |F_j|^2 exp(-|f - f_j|^2 / sigma_f^2): the amplitude's Gaussian squared. */
    double ensemblePower() {
        double sum = 0;
        for (int row = 0, i = 0; row < weightsY.length; row++) {
            double sumOfRow = 0;
            for (int column = 0; column < weightsX.length; column++, i++) {
                double weight = weightsX[column];
                sumOfRow += weight * weight * (real[i] * real[i] + imaginary[i] * imaginary[i]);
            }
            sum += weightsY[row] * weightsY[row] * sumOfRow;
        }
        return sum;
    }

    /** |sum_j F_j phase_j exp(-|f - f_j|^2 / (2 sigma_f^2))|^2, with the phases of all bins of the table's bands. */
    double coherentPower(double[][] phasesX, double[][] phasesY) {
        double sumReal = 0;
        double sumImaginary = 0;
        for (int row = 0, i = 0; row < weightsY.length; row++) {
            double rowReal = 0;
            double rowImaginary = 0;
            for (int column = 0; column < weightsX.length; column++, i++) {
                double cosine = weightsX[column] * phasesX[0][firstColumn + column];
                double sine = weightsX[column] * phasesX[1][firstColumn + column];
                rowReal += real[i] * cosine - imaginary[i] * sine;
                rowImaginary += real[i] * sine + imaginary[i] * cosine;
            }
            double cosine = weightsY[row] * phasesY[0][firstRow + row];
            double sine = weightsY[row] * phasesY[1][firstRow + row];
            sumReal += rowReal * cosine - rowImaginary * sine;
            sumImaginary += rowReal * sine + rowImaginary * cosine;
        }
        return sumReal * sumReal + sumImaginary * sumImaginary;
    }
}
