package sunbeam.precompute.reference;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.numerics.UnitCircle;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/** Sums p = exp(i k w h), or another function of the height, over the rows of a patch: one sum per column and per set of row weights. */
record SurfaceSums(HeightMap map, HeightLevels heights) {
    SurfaceSums(HeightMap map) {
        this(map, HeightLevels.of(map));
    }

    Sums overRows(double w, double wavelength, AxisWeights... alongY) {
        return heights.areTooManyToTabulate()
                ? overSamples(w, wavelength, alongY)
                : overRows(phases(w, wavelength), alongY);
    }

    /** Without a table of p by height; reads memory sequentially. */
    Sums overSamples(double w, double wavelength, AxisWeights... alongY) {
        double phasePerMeter = 2 * Math.PI / wavelength * w;
        return overRows(
                (row, real, imaginary) -> {
                    for (int column = 0; column < imaginary.length; column++) {
                        imaginary[column] = phasePerMeter * (map.at(column, row) - phaseZero());
                    }
                    // Replaces the phases by their sines.
                    UnitCircle.points(imaginary, real);
                },
                alongY);
    }

    /** Heights with an offset of millimeters would lose digits of the phase; meters. */
    private double phaseZero() {
        return 0.5 * (heights.minimum() + heights.maximum());
    }

    /** Sums any complex function of the height, given at each of {@link #heights()}'s levels. */
    Sums overRows(double[][] values, AxisWeights... alongY) {
        int[] index = heights.index();
        return overRows(
                (row, real, imaginary) -> {
                    for (int column = 0, i = row * real.length; column < real.length; column++, i++) {
                        real[column] = values[0][index[i]];
                        imaginary[column] = values[1][index[i]];
                    }
                },
                alongY);
    }

    private interface RowValues {
        void fill(int row, double[] real, double[] imaginary);
    }

    private Sums overRows(RowValues values, AxisWeights... alongY) {
        Sums sums = new Sums(new double[alongY.length][map.columns()], new double[alongY.length][map.columns()]);
        double[] real = new double[map.columns()];
        double[] imaginary = new double[map.columns()];
        for (int row = 0; row < map.rows(); row++) {
            int at = row;
            if (Arrays.stream(alongY).anyMatch(weights -> weights.real()[at] != 0 || weights.imaginary()[at] != 0)) {
                values.fill(row, real, imaginary);
                for (int b = 0; b < alongY.length; b++) {
                    sums.add(
                            b, real, imaginary, alongY[b].real()[row], alongY[b].imaginary()[row]);
                }
            }
        }
        return sums;
    }

    /** Returns exp(i k w h) of every distinct height: cosines, sines. */
    double[][] phases(double w, double wavelength) {
        double waveNumber = 2 * Math.PI / wavelength;
        double[] levels = heights.levels();
        double[] cosines = new double[levels.length];
        double[] sines = new double[levels.length];
        for (int i = 0; i < levels.length; i++) {
            sines[i] = waveNumber * w * (levels[i] - phaseZero());
        }
        UnitCircle.points(sines, cosines);
        return new double[][] {cosines, sines};
    }

    /** Complex sums over rows, {@code [weighting][column]}. */
    record Sums(double[][] real, double[][] imaginary) {
        private void add(int weighting, double[] re, double[] im, double weightReal, double weightImaginary) {
            double[] sumReal = real[weighting];
            double[] sumImaginary = imaginary[weighting];
            for (int i = 0; i < sumReal.length; i++) {
                sumReal[i] += re[i] * weightReal - im[i] * weightImaginary;
                sumImaginary[i] += re[i] * weightImaginary + im[i] * weightReal;
            }
        }

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
}
