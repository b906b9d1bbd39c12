package sunbeam.precompute.analysis;

import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.patch.HeightMap;

/**
 * Walls that are steeper than samples lie apart hold overtones beyond half the sampling frequency. These come back near the
 * wave itself, fs - n f or n f - fs, and their beat with it moves the wave's phase from one end of the scan to the other.
 * A slow beat draws the frequency to where there is none, fs / m, so that it does not show in what was found: all that
 * the windows let pass count alike. In directions between the axes each row has another beat, and their mean has none.
 */
final class SamplingBeat {
    // Multiples of the sampling frequency that are followed.
    private static final int MULTIPLES = 3;
    // Overtones below this share of the sampling frequency are seen as they are.
    private static final double SEEN = 0.45;
    // A jump's overtones fall as 1 / n; nothing physical falls more slowly.
    private static final double STEEPEST = 1;
    // Of the lines' mean square, in that of their mean: a straight wave that runs aslant has 0.4.
    private static final double ALIKE = 0.6;

    private SamplingBeat() {}

    /**
     * By how much the frequency of a wave may be wrong for its beats, cycles per metre.
     *
     * @param map without missing samples
     * @param frequencyX of the wave, cycles per metre
     * @param frequencyY cycles per metre, upwards
     * @param length over which the wave is followed, metres
     */
    static double error(HeightMap map, double frequencyX, double frequencyY, double length) {
        double[] axes = alongAxes(map, frequencyX, frequencyY, length);
        double frequency = Math.hypot(frequencyX, frequencyY);
        return (Math.abs(frequencyX) * axes[0] + Math.abs(frequencyY) * axes[1]) / frequency;
    }

    /** The same of the frequency's component across the wave, which turns its direction. */
    static double errorAcross(HeightMap map, double frequencyX, double frequencyY, double length) {
        double[] axes = alongAxes(map, frequencyX, frequencyY, length);
        double frequency = Math.hypot(frequencyX, frequencyY);
        return (Math.abs(frequencyY) * axes[0] + Math.abs(frequencyX) * axes[1]) / frequency;
    }

    /** Of the frequency's components along x and y. */
    private static double[] alongAxes(HeightMap map, double frequencyX, double frequencyY, double length) {
        double x = Math.abs(frequencyX);
        double y = Math.abs(frequencyY);
        boolean alongX = x >= y;
        double sampling = 1 / (alongX ? map.pitchX() : map.pitchY());
        double frequency = Math.max(x, y);
        // Of the overtone next to the sampling frequency, from one border to the other, in turns.
        double turned = sampling / frequency * Math.min(x, y) * (alongX ? map.height() : map.width());
        if (turned > 1) {
            return squares(map, x, y, length);
        }
        double error = alongAxis(profile(map, alongX), frequency, sampling, length);
        return alongX ? new double[] {error, 0} : new double[] {0, error};
    }

    /** Of waves across squares whose walls run along both axes: each row, and each column, is another or its mirror image. */
    private static double[] squares(HeightMap map, double x, double y, double length) {
        double[] rows = x > 0 && y > 0 ? alikeLines(map, true) : new double[0];
        double[] columns = rows.length > 0 ? alikeLines(map, false) : rows;
        return columns.length == 0
                ? new double[2]
                : new double[] {
                    alongAxis(rows, x, 1 / map.pitchX(), length), alongAxis(columns, y, 1 / map.pitchY(), length)
                };
    }

    /** Mean of all rows, or columns, those upside down turned up; empty where they are not alike. */
    private static double[] alikeLines(HeightMap map, boolean alongX) {
        int samples = alongX ? map.columns() : map.rows();
        int lines = alongX ? map.rows() : map.columns();
        double[] first = line(map, alongX, lines / 2);
        double[] mean = new double[samples];
        double squares = 0;
        for (int i = 0; i < lines; i++) {
            double[] line = line(map, alongX, i);
            double product = 0;
            for (int k = 0; k < samples; k++) {
                product += first[k] * line[k];
            }
            for (int k = 0; k < samples; k++) {
                mean[k] += Math.signum(product) * line[k] / lines;
                squares += line[k] * line[k] / lines;
            }
        }
        double ofMean = StatUtils.sumSq(mean);
        return ofMean >= ALIKE * squares ? mean : new double[0];
    }

    /** Of heights less its mean. */
    private static double[] line(HeightMap map, boolean alongX, int number) {
        double[] line = new double[alongX ? map.columns() : map.rows()];
        for (int k = 0; k < line.length; k++) {
            line[k] = alongX ? map.at(k, number) : map.at(number, k);
        }
        double mean = StatUtils.mean(line);
        for (int k = 0; k < line.length; k++) {
            line[k] -= mean;
        }
        return line;
    }

    private static double alongAxis(double[] profile, double frequency, double sampling, double length) {
        double jump = jump(profile, frequency / sampling);
        double error = 0;
        for (int multiple = 1; multiple <= MULTIPLES; multiple++) {
            long nearest = Math.round(multiple * sampling / frequency);
            for (long n = Math.max(2, nearest - 2); n <= nearest + 2; n++) {
                double beat = Math.abs(Math.abs(multiple * sampling - n * frequency) - frequency);
                double window = sinc(beat / frequency);
                error += jump / n * Math.abs(window * window * window) / length;
            }
        }
        return error;
    }

    /** Mean of all rows, or columns. */
    private static double[] profile(HeightMap map, boolean alongX) {
        double[] profile = new double[alongX ? map.columns() : map.rows()];
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                profile[alongX ? column : row] += map.at(column, row);
            }
        }
        return profile;
    }

    /**
     * A bound of n A(n) / A(1) for overtones that come back, from those that are seen: 1 for a saw of which each wall lies
     * between two samples, next to nothing for a wave without walls. What falls from the lower half of those seen to the
     * upper one falls on, at half that rate or more.
     *
     * @param turn of the wave from one sample to the next, in cycles
     */
    private static double jump(double[] profile, double turn) {
        int highest = (int) Math.floor(SEEN / turn);
        double first = amplitude(profile, turn);
        if (highest < 2 || first == 0) {
            return STEEPEST;
        }
        int middle = Math.max(1, highest / 2);
        double upper = largest(profile, turn, middle + 1, highest) / first;
        double lower = middle < 3 ? upper : largest(profile, turn, middle / 2 + 1, middle) / first;
        // From the middle of the upper half to 1 / turn there are some four times as many as between the halves'
        // middles.
        double falling = upper < lower ? Math.pow(upper / lower, 2) : 1;
        return Math.min(STEEPEST, upper * falling);
    }

    private static double largest(double[] profile, double turn, int from, int to) {
        double largest = 0;
        for (int n = from; n <= to; n++) {
            largest = Math.max(largest, n * amplitude(profile, n * turn));
        }
        return largest;
    }

    /** Under a Hann window, relative; the mean is left out. */
    private static double amplitude(double[] profile, double turn) {
        double mean = 0;
        for (double height : profile) {
            mean += height / profile.length;
        }
        double real = 0;
        double imaginary = 0;
        for (int i = 0; i < profile.length; i++) {
            double sine = Math.sin(Math.PI * (i + 0.5) / profile.length);
            double weighted = sine * sine * (profile[i] - mean);
            real += weighted * Math.cos(2 * Math.PI * turn * i);
            imaginary += weighted * Math.sin(2 * Math.PI * turn * i);
        }
        return Math.hypot(real, imaginary);
    }

    private static double sinc(double x) {
        return x == 0 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x);
    }
}
