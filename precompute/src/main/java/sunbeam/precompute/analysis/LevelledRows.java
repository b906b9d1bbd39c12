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
    // Of the heights' root mean square, in the rows' medians or means; a wave of few periods a row leaves more.
    private static final double LEVEL = 0.02;
    // Along a row: of more a row has all but whole periods, whose mean is nothing.
    private static final double MOST_PERIODS = 4;

    private LevelledRows() {}

    /** Whether that spoils a wave. */
    static boolean spoil(HeightMap map, SpectrumPeak peak) {
        return map.rows() >= FEWEST_ROWS
                && map.columns() > 1
                && Math.abs(peak.frequencyX()) * map.width() < MOST_PERIODS
                && areLevel(map);
    }

    private static boolean areLevel(HeightMap map) {
        double[] means = new double[map.rows()];
        double[] medians = new double[map.rows()];
        double squares = 0;
        for (int row = 0; row < map.rows(); row++) {
            double[] heights = new double[map.columns()];
            for (int column = 0; column < map.columns(); column++) {
                heights[column] = map.at(column, row);
            }
            means[row] = StatUtils.mean(heights);
            squares += StatUtils.populationVariance(heights, means[row]) / map.rows();
            Arrays.sort(heights);
            medians[row] = 0.5 * (heights[(heights.length - 1) / 2] + heights[heights.length / 2]);
        }
        double least = Math.min(StatUtils.populationVariance(means), StatUtils.populationVariance(medians));
        return least < LEVEL * LEVEL * squares;
    }
}
