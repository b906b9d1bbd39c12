package sunbeam.precompute.analysis;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.patch.HeightMap;

/**
 * Whether each row of a scan was levelled by itself, as many programs do on saving. Of a wave whose lines run nearly along the rows
 * that takes a part, another in each row, and bends what is left.
 */
final class LevelledRows {
    private static final int FEWEST_ROWS = 16;
    // Of the heights' root mean square, in what was levelled.
    private static final double LEVEL = 0.02;
    // Of the same, in what was not: flat ground that fills more than half of each row is level by itself.
    private static final double UNEVEN = 0.04;
    // Along a row: of more a row has all but whole periods, whose mean is nothing.
    private static final double MOST_PERIODS = 4;
    // Of its amplitude, in the mean of a row of the wave; of whole periods it is nothing.
    private static final double LEAST_MEAN = 0.1;
    // Less than one period a row, less its mean, looks like one.
    private static final double DRAWN_TO_ONE = 1.3;

    private LevelledRows() {}

    /** Whether that spoils a wave. */
    static boolean spoil(HeightMap map, SpectrumPeak peak) {
        double periods = Math.abs(peak.frequencyX()) * map.width();
        if (map.rows() < FEWEST_ROWS || map.columns() < 4 || periods >= MOST_PERIODS) {
            return false;
        }
        double[] means = new double[map.rows()];
        double[][] quarters = new double[3][map.rows()];
        double squares = 0;
        for (int row = 0; row < map.rows(); row++) {
            double[] heights = new double[map.columns()];
            for (int column = 0; column < map.columns(); column++) {
                heights[column] = map.at(column, row);
            }
            means[row] = StatUtils.mean(heights);
            squares += StatUtils.populationVariance(heights, means[row]) / map.rows();
            Arrays.sort(heights);
            for (int i = 0; i < quarters.length; i++) {
                quarters[i][row] = heights[(i + 1) * heights.length / 4];
            }
        }
        double angle = Math.PI * periods;
        boolean showsInMeans = periods < DRAWN_TO_ONE || Math.abs(Math.sin(angle) / angle) > LEAST_MEAN;
        boolean byMeans = showsInMeans && strays(means) < LEVEL * Math.sqrt(squares);
        double uneven = UNEVEN * Math.sqrt(squares);
        boolean byMedians = strays(quarters[1]) < LEVEL * Math.sqrt(squares)
                && strays(quarters[0]) > uneven
                && strays(quarters[2]) > uneven;
        return byMeans || byMedians;
    }

    private static double strays(double[] values) {
        return Math.sqrt(StatUtils.populationVariance(values));
    }
}
