package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.analysis.OrderLight.Efficiency;
import sunbeam.precompute.analysis.OrderSpectrum.Wave;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.ComplexVector;

/** Light around one order of a scan: its bins, whose transform is the order's field over the scan. */
final class OrderField {
    // Bins from the order within which lines are its own: a scan's ends and an uncertain period shift it by one.
    private static final int OWN = 3;
    // Half sides, in bins, of a line and of its surroundings.
    private static final int LINE = 1;
    private static final int AROUND = 3;
    // Mean of a line over that of its surroundings; the bins of a random surface reach 5.
    private static final double STANDS_OUT = 10;
    // Share of the order's light in a line.
    private static final double WEAKEST_LINE = 1e-3;

    private final List<Wave> bins = new ArrayList<>();
    private double power;

    void add(Wave wave, boolean kept) {
        power += wave.power();
        if (kept) {
            bins.add(wave);
        }
    }

    double power() {
        return power;
    }

    /**
     * Returns the mean with its 95 % interval. It is the interval of the logarithm, since means of few parts are skew (light of a random
     * surface has a gamma distribution); lines beside the order, such as of a wave that overlays the grating, lower its end.
     *
     * @param order the order's place among the bins, along x and y
     */
    Efficiency estimate(double[] order) {
        int left = bins.stream().mapToInt(Wave::x).min().orElse(0);
        int bottom = bins.stream().mapToInt(Wave::y).min().orElse(0);
        int columns = bins.stream().mapToInt(Wave::x).max().orElse(0) - left + 1;
        int rows = bins.stream().mapToInt(Wave::y).max().orElse(0) - bottom + 1;
        double[][] real = new double[rows][columns];
        double[][] imaginary = new double[rows][columns];
        double[][] powers = new double[rows][columns];
        for (Wave bin : bins) {
            real[bin.y() - bottom][bin.x() - left] = bin.real();
            imaginary[bin.y() - bottom][bin.x() - left] = bin.imaginary();
            powers[bin.y() - bottom][bin.x() - left] = bin.power();
        }
        if (columns * rows < 2 || power == 0) {
            return new Efficiency(power, Double.NaN, Double.NaN, 0);
        }
        ComplexVector field = new BandTransform2d(columns, rows, Band.of(0, columns - 1), Band.of(0, rows - 1))
                .transform((row, re, im) -> {
                    System.arraycopy(real[row], 0, re, 0, columns);
                    System.arraycopy(imaginary[row], 0, im, 0, columns);
                });
        double[] square = new double[field.length()];
        double scale = (double) columns * rows * columns * rows;
        Arrays.setAll(square, i -> scale * (Math.pow(field.real()[i], 2) + Math.pow(field.imaginary()[i], 2)));
        CorrelatedMean mean = CorrelatedMean.of(square, columns, rows);
        double student = new TDistribution(Math.max(1, mean.degreesOfFreedom()))
                .inverseCumulativeProbability(0.5 + 0.5 * GratingPeriod.PROBABILITY);
        double factor = Math.exp(student * mean.deviation() / power);
        double beside = beside(powers, order[0] - left, order[1] - bottom);
        return new Efficiency(power, (power - beside) / factor, Math.min(Math.max(1, power), power * factor), beside);
    }

    /** Returns the light of lines beside the order: bins that stand out, with their neighbors, from their surroundings. */
    private double beside(double[][] powers, double orderX, double orderY) {
        double sum = 0;
        for (int y = 0; y < powers.length; y++) {
            for (int x = 0; x < powers[y].length; x++) {
                if (Math.hypot(x - orderX, y - orderY) > OWN && isHighest(powers, x, y)) {
                    double line = around(powers, x, y, LINE);
                    int count = count(powers, x, y, LINE);
                    int others = count(powers, x, y, AROUND) - count;
                    double background = (around(powers, x, y, AROUND) - line) / Math.max(1, others);
                    boolean standsOut = others > 0 && line > STANDS_OUT * count * background;
                    sum += standsOut && line > WEAKEST_LINE * power ? line - count * background : 0;
                }
            }
        }
        return Math.min(sum, power);
    }

    private static boolean isHighest(double[][] powers, int x, int y) {
        double own = powers[y][x];
        for (int row = Math.max(0, y - LINE); row <= Math.min(powers.length - 1, y + LINE); row++) {
            for (int column = Math.max(0, x - LINE); column <= Math.min(powers[y].length - 1, x + LINE); column++) {
                if (powers[row][column] > own) {
                    return false;
                }
            }
        }
        return own > 0;
    }

    private static double around(double[][] powers, int x, int y, int reach) {
        double sum = 0;
        for (int row = Math.max(0, y - reach); row <= Math.min(powers.length - 1, y + reach); row++) {
            for (int column = Math.max(0, x - reach); column <= Math.min(powers[y].length - 1, x + reach); column++) {
                sum += powers[row][column];
            }
        }
        return sum;
    }

    private static int count(double[][] powers, int x, int y, int reach) {
        int columns = Math.min(powers[y].length - 1, x + reach) - Math.max(0, x - reach) + 1;
        return columns * (Math.min(powers.length - 1, y + reach) - Math.max(0, y - reach) + 1);
    }

    /**
     * Standard deviation of the mean of a field whose values are correlated, from the means of up to 16 x 16 cells: half the mean square
     * difference of cells (variogram), which knows no mean, gives the distance at which the correlation is 1/2 along each axis, and a
     * Gaussian correlation the variance of the mean.
     *
     * @param degreesOfFreedom number of independent values of the same variance of the mean, less one; fewer for values more skew than the
     *     light of a random surface, whose variance is the square of its mean
     */
    record CorrelatedMean(double deviation, double degreesOfFreedom) {
        private static final int CELLS = 16;
        // The variance of the mean adds to that of cells about it: a fixed point, approached by a factor of 2 or more.
        private static final int ROUNDS = 8;
        // Half width of exp(-x^2 / 2).
        private static final double HALF = Math.sqrt(2 * Math.log(2));
        // Share of the cells' variance that the mean keeps, of a field that varies over the scan and not within it.
        private static final double MOST_COMMON = 0.9;

        static CorrelatedMean of(double[] values, int columns, int rows) {
            int across = Math.min(CELLS, columns);
            int up = Math.min(CELLS, rows);
            double[][] cells = new double[up][across];
            int[][] counts = new int[up][across];
            for (int i = 0; i < values.length; i++) {
                int row = i / columns * up / rows;
                int column = i % columns * across / columns;
                cells[row][column] += values[i];
                counts[row][column]++;
            }
            double[][] turned = new double[across][up];
            for (int row = 0; row < up; row++) {
                for (int column = 0; column < across; column++) {
                    cells[row][column] /= counts[row][column];
                    turned[column][row] = cells[row][column];
                }
            }
            double variance = StatUtils.populationVariance(
                    Arrays.stream(cells).flatMapToDouble(Arrays::stream).toArray());
            double[] gammaX = variogram(cells);
            double[] gammaY = variogram(turned);
            double ofMean = variance / (up * across);
            for (int round = 0; round < ROUNDS; round++) {
                double common = Math.min(
                        MOST_COMMON, common(gammaX, variance + ofMean, across) * common(gammaY, variance + ofMean, up));
                ofMean = variance * common / (1 - common);
            }
            double parts = ofMean > 0 ? (variance + ofMean) / ofMean : CELLS * CELLS;
            double skewness = Math.max(1, (variance + ofMean) / Math.pow(StatUtils.mean(values), 2));
            return new CorrelatedMean(Math.sqrt(ofMean), (parts - 1) / skewness);
        }

        /** Returns half the mean square difference of cells in a row, by distance. */
        private static double[] variogram(double[][] cells) {
            int count = cells[0].length;
            double[] gamma = new double[count / 2 + 1];
            for (int lag = 1; lag < gamma.length; lag++) {
                for (double[] row : cells) {
                    for (int i = lag; i < count; i++) {
                        gamma[lag] += 0.5 * Math.pow(row[i] - row[i - lag], 2) / (count - lag) / cells.length;
                    }
                }
            }
            return gamma;
        }

        /** Returns the mean correlation of two cells in a row. */
        private static double common(double[] gamma, double sill, int count) {
            double length = length(gamma, sill);
            double sum = 0;
            for (int lag = 1 - count; lag < count; lag++) {
                double correlation = lag == 0 ? 1 : Math.exp(-0.5 * Math.pow(lag / length, 2));
                sum += correlation * (count - Math.abs(lag)) / count / count;
            }
            return sum;
        }

        /** Returns the standard deviation, in cells, of the Gaussian correlation; 0 without any. */
        private static double length(double[] gamma, double sill) {
            int lag = 1;
            while (lag < gamma.length && gamma[lag] < 0.5 * sill) {
                lag++;
            }
            if (lag == 1 && gamma.length > 1) {
                return gamma[1] < sill ? 1 / Math.sqrt(-2 * Math.log(1 - gamma[1] / sill)) : 0;
            }
            if (lag == gamma.length) {
                double last = gamma[lag - 1] / sill;
                return last > 0 ? (lag - 1) * Math.sqrt(0.5 / last) / HALF : Double.POSITIVE_INFINITY;
            }
            double below = gamma[lag - 1];
            return (lag - 1 + (0.5 * sill - below) / (gamma[lag] - below)) / HALF;
        }
    }
}
