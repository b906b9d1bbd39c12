package sunbeam.precompute.analysis;

import java.util.Arrays;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform;
import sunbeam.precompute.fourier.ComplexVector;

/**
 * Amplitudes of a wave in one row after the other, less what other waves add that have the same frequency along the rows: those of
 * a lattice, whose beat turns the phase by half a period where it passes zero, as if rows had slipped. Such waves are sharp lines in
 * the spectrum over the rows; rows are averaged until the nearest has gone.
 *
 * @param amplitudes complex, {@code [place][re, im]}
 * @param step rows between places; 1 where nothing beats
 * @param window rows that are averaged; 1 where nothing beats
 */
record BeatingRows(double[][] amplitudes, int step, int window) {
    // A Hann window spreads a line over so many bins on both sides; and what is near it.
    private static final int LINE_BINS = 2;
    private static final int NEAR_BINS = 5;
    // Of what is near it, in a line.
    private static final double SHARP = 0.8;
    // Of the line of the wave itself, that another must have to turn phases much.
    private static final double LEAST_BESIDE = 0.1;
    // Of all, in sharp lines: slips at random leave none.
    private static final double LEAST_TOGETHER = 0.5;
    private static final double ONE_SIZE = 0.97;
    // So many at equal distances, by half a period each, are hard squares; no scanner slips so.
    private static final int SURE_BEATS = 7;
    // Beats under the window, which has its second zero there.
    private static final int BEATS = 3;

    /** Averages them where others beat with them. */
    static BeatingRows in(double[][] rows) {
        int nearest = nearestBeside(power(rows));
        if (nearest < SURE_BEATS && areOfOneSize(rows)) {
            nearest = 0;
        }
        if (nearest == 0) {
            return new BeatingRows(rows, 1, 1);
        }
        int step = (rows.length + nearest - 1) / nearest;
        int window = Math.min(BEATS * step, rows.length);
        double[][] averages = new double[(rows.length - window) / step + 1][2];
        for (int place = 0; place < averages.length; place++) {
            for (int i = 0; i < window; i++) {
                double weight = hann(i, window);
                averages[place][0] += weight * rows[place * step + i][0];
                averages[place][1] += weight * rows[place * step + i][1];
            }
        }
        return new BeatingRows(averages, step, window);
    }

    /** The first row after a jump between a place and the one before. */
    int row(int place) {
        return step == 1 ? place : (int) Math.round((place - 0.5) * step + 0.5 * window);
    }

    /** As slips leave them; by a wave of a third beside, (mean size)^2 is 0.95 of the mean square. */
    private static boolean areOfOneSize(double[][] rows) {
        double sizes = 0;
        double squares = 0;
        for (double[] row : rows) {
            sizes += Math.hypot(row[0], row[1]);
            squares += row[0] * row[0] + row[1] * row[1];
        }
        return sizes * sizes >= ONE_SIZE * squares * rows.length;
    }

    /** Over the rows under a Hann window, the wave's own frequency in the middle. */
    private static double[] power(double[][] rows) {
        int reach = (rows.length - 1) / 2;
        BandTransform transform = new BandTransform(rows.length, Band.of(-reach, reach));
        ComplexVector work = transform.workspace();
        for (int row = 0; row < rows.length; row++) {
            work.real()[row] = hann(row, rows.length) * rows[row][0];
            work.imaginary()[row] = hann(row, rows.length) * rows[row][1];
        }
        ComplexVector bins = ComplexVector.zeros(2 * reach + 1);
        transform.transform(work, bins, 0, 1);
        double[] power = new double[bins.length()];
        Arrays.setAll(power, i -> bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i]);
        return power;
    }

    /** Bins between the wave's line and the nearest other; 0 where there is none. */
    private static int nearestBeside(double[] power) {
        int middle = power.length / 2;
        double own = sum(power, middle, LINE_BINS);
        double together = 0;
        int nearest = 0;
        for (int bin = 0; bin < power.length; bin++) {
            double line = sum(power, bin, LINE_BINS);
            if (isTop(power, bin) && line >= SHARP * sum(power, bin, NEAR_BINS)) {
                together += line;
                int away = Math.abs(bin - middle);
                boolean another = away > 2 * LINE_BINS && line >= LEAST_BESIDE * own;
                nearest = another && (nearest == 0 || away < nearest) ? away : nearest;
            }
        }
        return together >= LEAST_TOGETHER * Arrays.stream(power).sum() ? nearest : 0;
    }

    private static double sum(double[] power, int bin, int reach) {
        double sum = 0;
        for (int i = Math.max(0, bin - reach); i <= Math.min(power.length - 1, bin + reach); i++) {
            sum += power[i];
        }
        return sum;
    }

    private static boolean isTop(double[] power, int bin) {
        for (int i = Math.max(0, bin - LINE_BINS); i <= Math.min(power.length - 1, bin + LINE_BINS); i++) {
            if (power[i] > power[bin] || (power[i] == power[bin] && i < bin)) {
                return false;
            }
        }
        return power[bin] > 0;
    }

    private static double hann(int at, int samples) {
        return Math.pow(Math.sin(Math.PI * (at + 0.5) / samples), 2);
    }
}
