package sunbeam.precompute.analysis;

import java.util.Arrays;
import org.apache.commons.math3.distribution.TDistribution;
import sunbeam.precompute.optics.HeightMap;

/**
 * The phase of a wave in windows side by side along one direction, against the wave of exactly the given frequency: its slope is
 * the correction of the frequency along that direction, and what the phase does besides says how well the slope is known.
 *
 * <p>Windows are Hann windows of two periods, under which constants, slopes, overtones and the wave's mirror image vanish.
 */
final class DemodulatedPhase {
    // Parts of a window between the places at which the phase is followed, so that it turns by less than half from one
    // to the
    // next.
    private static final int PARTS = 3;
    // Nodes of a window: samples are shared out between the two beside them first.
    private static final int CELLS = 48;
    // Of the fullest window's samples: corners of a scan hold less.
    private static final double LEAST_FILLED = 0.3;

    // Steps from one Hann window to the next are smaller than a random walk's own, by 0.8 in the square, or by half
    // where
    // neighboring gaps deviate alike.
    private static final double SMOOTHED = 1.4;

    private final double[] places;
    private final double[] phases;
    private final double[] weights;
    private final int first;
    private final int last;

    private DemodulatedPhase(double[] places, double[] phases, double[] weights, int first, int last) {
        this.places = places;
        this.phases = phases;
        this.weights = weights;
        this.first = first;
        this.last = last;
    }

    /**
     * Follows a wave.
     *
     * @param level heights less their plane
     * @param azimuth of the direction along which it is followed, radians
     * @param window length of a window, metres
     * @param tapered whether heights fade to both sides of the direction
     */
    static DemodulatedPhase of(HeightMap level, SpatialFrequency wave, double azimuth, double window, boolean tapered) {
        double cosine = Math.cos(azimuth);
        double sine = Math.sin(azimuth);
        double length = level.width() * Math.abs(cosine) + level.height() * Math.abs(sine);
        double cell = window / CELLS;
        int cells = 2 + (int) Math.ceil(length / cell);
        double[][] sums = new double[3][cells];
        accumulate(level, wave, cosine, sine, tapered, cell, sums);
        int windows = Math.max(3, (int) (length / window));
        int count = PARTS * (windows - 1) + 1;
        double[] places = new double[count];
        double[] phases = new double[count];
        double[] weights = new double[count];
        double[] filled = new double[count];
        for (int i = 0; i < count; i++) {
            places[i] = 0.5 * Math.min(window, length) + Math.max(0, length - window) * i / (count - 1);
            double re = 0;
            double im = 0;
            int from = Math.max(0, (int) Math.ceil((places[i] - 0.5 * window) / cell));
            for (int k = from; k < cells && k * cell < places[i] + 0.5 * window; k++) {
                double turn = Math.cos(Math.PI * (k * cell - places[i]) / window);
                double hann = turn * turn;
                re += hann * sums[0][k];
                im += hann * sums[1][k];
                filled[i] += hann * sums[2][k];
            }
            phases[i] = Math.atan2(im, re);
            weights[i] = Math.hypot(re, im);
        }
        double fullest = Arrays.stream(filled).max().orElseThrow();
        int first = 0;
        int last = count - 1;
        while (last - first > 2 * PARTS && Math.min(filled[first], filled[last]) < LEAST_FILLED * fullest) {
            if (filled[first] < filled[last]) {
                first += PARTS;
            } else {
                last -= PARTS;
            }
        }
        return new DemodulatedPhase(places, unwrapped(phases), weights, first, last);
    }

    /** Heights times exp(-2 pi i f x), and samples, of each cell. */
    private static void accumulate(
            HeightMap level,
            SpatialFrequency wave,
            double alongX,
            double alongY,
            boolean tapered,
            double cell,
            double[][] sums) {
        double length = level.width() * Math.abs(alongX) + level.height() * Math.abs(alongY);
        double breadth = level.width() * Math.abs(alongY) + level.height() * Math.abs(alongX);
        int columns = level.columns();
        double[] cosines = new double[columns];
        double[] sines = new double[columns];
        for (int column = 0; column < columns; column++) {
            double angle = -2 * Math.PI * wave.x() * (column + 0.5 - 0.5 * columns) * level.pitchX();
            cosines[column] = Math.cos(angle);
            sines[column] = Math.sin(angle);
        }
        for (int row = 0; row < level.rows(); row++) {
            double y = (0.5 * level.rows() - row - 0.5) * level.pitchY();
            double angle = -2 * Math.PI * wave.y() * y;
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            for (int column = 0; column < columns; column++) {
                double x = (column + 0.5 - 0.5 * columns) * level.pitchX();
                double place = 0.5 * length + x * alongX + y * alongY;
                int k = Math.min(sums[0].length - 2, (int) (place / cell));
                double after = place / cell - k;
                double turn = tapered ? Math.cos(Math.PI * (y * alongX - x * alongY) / breadth) : 1;
                double height = turn * turn * level.at(column, row);
                double re = height * (cosines[column] * cosine - sines[column] * sine);
                double im = height * (cosines[column] * sine + sines[column] * cosine);
                sums[0][k] += (1 - after) * re;
                sums[0][k + 1] += after * re;
                sums[1][k] += (1 - after) * im;
                sums[1][k + 1] += after * im;
                sums[2][k] += 1 - after;
                sums[2][k + 1] += after;
            }
        }
    }

    private static double[] unwrapped(double[] phases) {
        double[] result = phases.clone();
        for (int i = 1; i < result.length; i++) {
            result[i] = result[i - 1] + Math.IEEEremainder(phases[i] - phases[i - 1], 2 * Math.PI);
        }
        return result;
    }

    /**
     * What is to be added to the wave's frequency along the direction.
     *
     * @param value cycles per metre
     * @param halfWidth of its interval, cycles per metre
     */
    record Slope(double value, double halfWidth) {
        static final Slope UNKNOWN = new Slope(0, Double.POSITIVE_INFINITY);
    }

    /**
     * Unknown where a single window fits. Weighted least squares over windows side by side. Its standard error is the larger of that of white phases (lines that
     * stray, noise) and that of a random walk (gaps that deviate), times Student's factor.
     *
     * @param probability of the interval
     */
    Slope slope(double probability) {
        int count = (last - first) / PARTS + 1;
        double[] sums = new double[5];
        for (int i = first; i <= last; i += PARTS) {
            double[] terms = {1, places[i], places[i] * places[i], phases[i], places[i] * phases[i]};
            for (int k = 0; k < sums.length; k++) {
                sums[k] += weights[i] * terms[k];
            }
        }
        if (!(places[last] - places[first] > 0)) {
            return Slope.UNKNOWN;
        }
        double middle = sums[1] / sums[0];
        double spread = sums[2] - middle * sums[1];
        double slope = (sums[4] - middle * sums[3]) / spread;
        double mean = sums[3] / sums[0];
        double squares = 0;
        double steps = 0;
        for (int i = first; i <= last; i += PARTS) {
            double rest = phases[i] - mean - slope * (places[i] - middle);
            squares += weights[i] * rest * rest;
            if (i > first) {
                double step = phases[i] - phases[i - PARTS] - slope * (places[i] - places[i - PARTS]);
                steps += step * step;
            }
        }
        int degrees = count - 2;
        double white = Math.sqrt(squares / degrees / spread);
        double walk = SMOOTHED * Math.sqrt(steps * (count - 1) / degrees) / (places[last] - places[first]);
        double student = new TDistribution(degrees).inverseCumulativeProbability(0.5 + 0.5 * probability);
        return new Slope(slope / (2 * Math.PI), student * Math.max(white, walk) / (2 * Math.PI));
    }
}
