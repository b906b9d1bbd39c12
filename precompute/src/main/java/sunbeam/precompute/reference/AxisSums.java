package sunbeam.precompute.reference;

import org.apache.commons.math3.complex.Complex;

/** Running complex sums over rows: one sum per column and per set of row weights. */
final class AxisSums {
    private final double[][] real;
    private final double[][] imaginary;

    AxisSums(int columns, int weightings) {
        real = new double[weightings][columns];
        imaginary = new double[weightings][columns];
    }

    void add(int weighting, double[] valueReal, double[] valueImaginary, double weightReal, double weightImaginary) {
        double[] targetReal = real[weighting];
        double[] targetImaginary = imaginary[weighting];
        for (int i = 0; i < targetReal.length; i++) {
            targetReal[i] += valueReal[i] * weightReal - valueImaginary[i] * weightImaginary;
            targetImaginary[i] += valueReal[i] * weightImaginary + valueImaginary[i] * weightReal;
        }
    }

    /** |sum over columns|^2 with the columns' weights. */
    double power(int weighting, AxisWeights alongX) {
        Complex sum = sum(weighting, alongX);
        return sum.getReal() * sum.getReal() + sum.getImaginary() * sum.getImaginary();
    }

    Complex sum(int weighting, AxisWeights alongX) {
        double sumReal = 0;
        double sumImaginary = 0;
        for (int i = 0; i < real[weighting].length; i++) {
            double a = real[weighting][i];
            double b = imaginary[weighting][i];
            sumReal += a * alongX.real()[i] - b * alongX.imaginary()[i];
            sumImaginary += a * alongX.imaginary()[i] + b * alongX.real()[i];
        }
        return new Complex(sumReal, sumImaginary);
    }
}
