package sunbeam.precompute.reference;

import sunbeam.precompute.numerics.UnitCircle;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/** Sums p = exp(i k w h), or another function of the height, over the rows of a patch: one sum per column and per set of row weights. */
final class SurfaceSums {
    // Above this share of distinct heights a table of p by height is slower than computing p at each sample.
    private static final double MOST_DISTINCT = 0.2;

    private final HeightMap map;
    private final HeightLevels heights;

    SurfaceSums(HeightMap map) {
        this.map = map;
        this.heights = HeightLevels.of(map);
    }

    HeightLevels heights() {
        return heights;
    }

    AxisSums overRows(double w, double wavelength, AxisWeights... alongY) {
        return heights.count() < MOST_DISTINCT * map.columns() * map.rows()
                ? overRows(phases(w, wavelength), alongY)
                : overSamples(w, wavelength, alongY);
    }

    /** Without a table of p by height; reads memory sequentially. */
    private AxisSums overSamples(double w, double wavelength, AxisWeights... alongY) {
        int columns = map.columns();
        double phasePerMeter = 2 * Math.PI / wavelength * w;
        AxisSums sums = new AxisSums(columns, alongY.length);
        double[] cosines = new double[columns];
        double[] sines = new double[columns];
        for (int row = 0; row < map.rows(); row++) {
            if (!hasWeight(row, alongY)) {
                continue;
            }
            for (int column = 0; column < columns; column++) {
                sines[column] = phasePerMeter * (map.at(column, row) - phaseZero());
            }
            // Replaces the phases in sines by their sines.
            UnitCircle.points(sines, cosines);
            for (int b = 0; b < alongY.length; b++) {
                sums.add(b, cosines, sines, alongY[b].real()[row], alongY[b].imaginary()[row]);
            }
        }
        return sums;
    }

    /** Meters. */
    private double phaseZero() {
        return 0.5 * (heights.minimum() + heights.maximum());
    }

    /** Sums any complex function of the height, given at each of {@link #heights()}'s levels. */
    AxisSums overRows(double[][] values, AxisWeights... alongY) {
        int columns = map.columns();
        AxisSums sums = new AxisSums(columns, alongY.length);
        double[] real = new double[columns];
        double[] imaginary = new double[columns];
        int[] index = heights.index();
        for (int row = 0; row < map.rows(); row++) {
            if (!hasWeight(row, alongY)) {
                continue;
            }
            for (int column = 0, i = row * columns; column < columns; column++, i++) {
                real[column] = values[0][index[i]];
                imaginary[column] = values[1][index[i]];
            }
            for (int b = 0; b < alongY.length; b++) {
                sums.add(b, real, imaginary, alongY[b].real()[row], alongY[b].imaginary()[row]);
            }
        }
        return sums;
    }

    private static boolean hasWeight(int row, AxisWeights[] alongY) {
        for (AxisWeights weights : alongY) {
            if (weights.real()[row] != 0 || weights.imaginary()[row] != 0) {
                return true;
            }
        }
        return false;
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
        // Replaces the phases in sines by their sines.
        UnitCircle.points(sines, cosines);
        return new double[][] {cosines, sines};
    }
}
