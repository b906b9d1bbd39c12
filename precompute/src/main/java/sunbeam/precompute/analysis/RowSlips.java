package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.numerics.UnitCircle;
import sunbeam.precompute.patch.HeightMap;

/**
 * Rows at which a scanner slipped: from one to the next the phase of a wave jumps, by far more than between any others.
 * Each row is demodulated by itself, so that it needs a few periods along it; waves that run along the columns show
 * no sideways slip.
 *
 * @param slips from top to bottom
 * @param turnsARow by how much the wave's phase goes beyond the frequency that it was looked for at, from row to row, where nothing
 *     slips; periods, downwards
 * @param deviation of these, periods
 */
record RowSlips(List<PeriodEstimate.Slip> slips, double turnsARow, double deviation) {
    // Along a row, so that a row's amplitude is the wave's and not the mirror frequency's.
    private static final double FEWEST_PERIODS = 3;
    // Rows on each side of a slip whose phases are averaged.
    private static final int[] REACHES = {1, 2, 4};
    private static final int FEWEST_ROWS = 8;
    // Of turns between neighbours: from the median in units of the deviation, and in turns.
    private static final double STANDS_OUT = 8;
    private static final double LEAST_TURNS = 0.02;
    // Rows for each slip: a scanner that slips at every few rows breaks the wave up. Where that goes on all the same,
    // rows are
    // alike in pairs, or samples round its walls, and nothing slips.
    private static final int ROWS_A_SLIP = 5;
    // Of the sum of all rows' amplitudes over that of their sizes: phases within a twelfth of a period.
    private static final double GOES_ON = 0.9;
    // Of a normal distribution, over the median of absolute deviations.
    private static final double SIGMA = 1.4826;

    /**
     * Looks for slips.
     *
     * @param map without missing samples
     * @param frequencyX of the wave, cycles per metre
     * @param frequencyY cycles per metre, upwards
     */
    static RowSlips in(HeightMap map, double frequencyX, double frequencyY) {
        if (Math.abs(frequencyX) * map.width() < FEWEST_PERIODS || map.rows() < 2 * FEWEST_ROWS) {
            return new RowSlips(List.of(), 0, 0);
        }
        BeatingRows rows = BeatingRows.in(amplitudes(map, frequencyX, frequencyY));
        double[][] amplitudes = rows.amplitudes();
        if (amplitudes.length < 2 * FEWEST_ROWS) {
            return new RowSlips(List.of(), 0, 0);
        }
        List<PeriodEstimate.Slip> slips = new ArrayList<>();
        for (int reach : REACHES) {
            for (PeriodEstimate.Slip slip : new Turns(amplitudes, reach).jumps()) {
                if (slips.stream().noneMatch(other -> Math.abs(other.row() - slip.row()) <= 2 * reach)) {
                    slips.add(slip);
                }
            }
        }
        if (slips.size() * ROWS_A_SLIP > amplitudes.length && coherence(amplitudes) > GOES_ON) {
            slips.clear();
        }
        slips.sort((a, b) -> Integer.compare(a.row(), b.row()));
        Turns beside = new Turns(amplitudes, REACHES[0]);
        List<PeriodEstimate.Slip> inRows = slips.stream()
                .map(slip -> new PeriodEstimate.Slip(rows.row(slip.row()), slip.turns()))
                .toList();
        return new RowSlips(inRows, beside.median / rows.step(), beside.deviation);
    }

    /** 0..1: whether the rows' amplitudes have one phase. */
    private static double coherence(double[][] amplitudes) {
        double[] together = sum(amplitudes, 0, amplitudes.length);
        double sizes = Arrays.stream(amplitudes)
                .mapToDouble(row -> Math.hypot(row[0], row[1]))
                .sum();
        return sizes > 0 ? Math.hypot(together[0], together[1]) / sizes : 0;
    }

    /** Complex, of each row under a Hann window, less the row's mean and slope. */
    private static double[][] amplitudes(HeightMap map, double frequencyX, double frequencyY) {
        int columns = map.columns();
        double[] sines = new double[columns];
        double[] cosines = new double[columns];
        for (int column = 0; column < columns; column++) {
            sines[column] = -2 * Math.PI * frequencyX * map.pitchX() * (column - 0.5 * (columns - 1));
        }
        UnitCircle.points(sines, cosines);
        for (int column = 0; column < columns; column++) {
            double window = Math.pow(Math.sin(Math.PI * (column + 0.5) / columns), 2);
            sines[column] *= window;
            cosines[column] *= window;
        }
        double[] constant = sums(column -> 1, cosines, sines);
        double[] slope = sums(column -> column - 0.5 * (columns - 1), cosines, sines);
        double squares = (double) columns * ((double) columns * columns - 1) / 12;
        double[][] amplitudes = new double[map.rows()][];
        for (int row = 0; row < map.rows(); row++) {
            int here = row;
            double mean = 0;
            double moment = 0;
            for (int column = 0; column < columns; column++) {
                mean += map.at(column, row) / columns;
                moment += map.at(column, row) * (column - 0.5 * (columns - 1)) / squares;
            }
            double[] sum = sums(column -> map.at(column, here), cosines, sines);
            double real = sum[0] - mean * constant[0] - moment * slope[0];
            double imaginary = sum[1] - mean * constant[1] - moment * slope[1];
            double angle = 2 * Math.PI * frequencyY * map.pitchY() * row;
            amplitudes[row] = new double[] {
                real * Math.cos(angle) - imaginary * Math.sin(angle),
                real * Math.sin(angle) + imaginary * Math.cos(angle)
            };
        }
        return amplitudes;
    }

    @FunctionalInterface
    private interface Values {
        double at(int column);
    }

    private static double[] sums(Values values, double[] cosines, double[] sines) {
        double[] sum = new double[2];
        for (int column = 0; column < cosines.length; column++) {
            double value = values.at(column);
            sum[0] += value * cosines[column];
            sum[1] += value * sines[column];
        }
        return sum;
    }

    /** Turns between so many rows before and as many after each, periods. */
    private static final class Turns {
        private final int reach;
        private final double[] turns;
        private final double[] away;
        private final double median;
        private final double deviation;

        Turns(double[][] amplitudes, int reach) {
            this.reach = reach;
            this.turns = new double[amplitudes.length - 2 * reach + 1];
            for (int i = 0; i < turns.length; i++) {
                double[] before = sum(amplitudes, i, reach);
                double[] after = sum(amplitudes, i + reach, reach);
                turns[i] = Math.atan2(
                                after[1] * before[0] - after[0] * before[1],
                                after[0] * before[0] + after[1] * before[1])
                        / (2 * Math.PI);
            }
            this.median = StatUtils.percentile(turns, 50);
            this.away = Arrays.stream(turns)
                    .map(turn -> Math.abs(Math.IEEEremainder(turn - median, 1)))
                    .toArray();
            this.deviation = SIGMA * StatUtils.percentile(away, 50);
        }

        /** Those that stand out of all others and of those beside. */
        List<PeriodEstimate.Slip> jumps() {
            List<PeriodEstimate.Slip> slips = new ArrayList<>();
            for (int i = 0; i < turns.length; i++) {
                if (away[i] > Math.max(LEAST_TURNS, STANDS_OUT * deviation) && isLargest(away, i, reach)) {
                    slips.add(new PeriodEstimate.Slip(reach + i, Math.IEEEremainder(turns[i] - median, 1)));
                }
            }
            return slips;
        }
    }

    private static boolean isLargest(double[] values, int at, int reach) {
        for (int i = Math.max(0, at - reach); i <= Math.min(values.length - 1, at + reach); i++) {
            if (values[i] > values[at] || (values[i] == values[at] && i < at)) {
                return false;
            }
        }
        return true;
    }

    private static double[] sum(double[][] amplitudes, int from, int count) {
        double[] sum = new double[2];
        for (int row = from; row < from + count; row++) {
            sum[0] += amplitudes[row][0];
            sum[1] += amplitudes[row][1];
        }
        return sum;
    }
}
