package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;

/** Correction of a wave's frequency by the slope of its phase along one direction, and its 95 % interval's half width; cycles per meter. */
record PhaseSlope(double value, double halfWidth) {
    // With two periods, constants, slopes, overtones and the negative frequency vanish.
    private static final int WINDOW_PERIODS = 2;
    // The phase changes by less than half a turn between overlapping windows.
    private static final int PER_LENGTH = 3;
    // Side by side; in a short scan, they overlap more.
    private static final int FEWEST_WINDOWS = 3;
    // Share of the fullest window's weight; windows in corners have less.
    private static final double LEAST_FILLED = 0.3;
    // Steps of a random walk's means under Hann windows have half the mean square of its own.
    private static final double SMOOTHED = 1.4;
    // Standard error of gratings, cycles per length, and its degrees of freedom: few windows do not tell their error.
    private static final double USUAL = 0.01;
    private static final double USUAL_DEGREES = 5;
    // Ratio of a steady wave's median to its mean.
    private static final double STEADY = 0.5;
    // Bands of rows of one phase each; a scanner slips within few.
    private static final int BANDS = 48;
    // Periods along a row, which has a Hann window of its own.
    private static final double FEWEST_IN_A_ROW = 3;

    /** Hann windows: sums of heights times exp(-2 pi i f x), and of weights. */
    private record Windows(double[] re, double[] im, double[] filled) {
        double weight(int i) {
            return Math.hypot(re[i], im[i]);
        }

        double[] phases() {
            double[] phases = new double[re.length];
            for (int i = 0; i < phases.length; i++) {
                double phase = Math.atan2(im[i], re[i]);
                phases[i] = i == 0 ? phase : phases[i - 1] + Math.IEEEremainder(phase - phases[i - 1], 2 * Math.PI);
            }
            return phases;
        }
    }

    /** Subtracts the wave with its amplitude and phase under a Hann window. */
    static HeightMap without(HeightMap level, SpatialFrequency wave) {
        double re = 0;
        double im = 0;
        double sum = 0;
        double[] cosines = new double[level.columns() * level.rows()];
        double[] sines = new double[cosines.length];
        for (int i = 0; i < cosines.length; i++) {
            int column = i % level.columns();
            int row = i / level.columns();
            double angle = 2 * Math.PI * (wave.x() * column * level.pitchX() - wave.y() * row * level.pitchY());
            cosines[i] = Math.cos(angle);
            sines[i] = Math.sin(angle);
            double root = Math.sin(Math.PI * (column + 0.5) / level.columns())
                    * Math.sin(Math.PI * (row + 0.5) / level.rows());
            re += root * root * level.at(column, row) * cosines[i];
            im += root * root * level.at(column, row) * sines[i];
            sum += root * root;
        }
        double[] left = level.heights().clone();
        for (int i = 0; i < left.length; i++) {
            left[i] -= 2 * (re * cosines[i] + im * sines[i]) / sum;
        }
        return level.with(left);
    }

    /** @param across along the wave's lines instead of along the wave */
    static PhaseSlope of(HeightMap level, SpatialFrequency wave, boolean across) {
        double azimuth = Math.atan2(wave.y(), wave.x()) + (across ? 0.5 * Math.PI : 0);
        double length = extent(level, azimuth);
        double window = WINDOW_PERIODS * wave.period();
        int count = PER_LENGTH * (Math.max(FEWEST_WINDOWS, (int) (length / window)) - 1) + 1;
        double step = (length - window) / (count - 1);
        if (!(step > 0)) {
            return new PhaseSlope(0, Double.POSITIVE_INFINITY);
        }
        Windows windows = windows(count, level, wave, azimuth, step, across);
        double fullest = Arrays.stream(windows.filled()).max().orElseThrow();
        int first = 0;
        int last = count - 1;
        while (last - first > 2 * PER_LENGTH
                && Math.min(windows.filled()[first], windows.filled()[last]) < LEAST_FILLED * fullest) {
            boolean atStart = windows.filled()[first] < windows.filled()[last];
            first += atStart ? PER_LENGTH : 0;
            last -= atStart ? 0 : PER_LENGTH;
        }
        return fitted(windows, first, last, step);
    }

    /** Whether the scan is longer than a window along the wave's lines, so that their direction has an interval. */
    static boolean hasDirection(HeightMap level, SpatialFrequency wave) {
        return extent(level, wave.azimuth() + 0.5 * Math.PI) > WINDOW_PERIODS * wave.period();
    }

    /** Whether a wave has its phase and amplitude in most windows along it, not in those of a defect alone. */
    static boolean isSteady(HeightMap level, SpatialFrequency wave) {
        double azimuth = Math.atan2(wave.y(), wave.x());
        double window = WINDOW_PERIODS * wave.period();
        double length = extent(level, azimuth);
        int count = Math.max(FEWEST_WINDOWS, (int) (length / window));
        double step = (length - window) / (count - 1);
        if (!(step > 0)) {
            return true;
        }
        Windows windows = windows(count, level, wave, azimuth, step, false);
        double mean = Math.atan2(StatUtils.sum(windows.im()), StatUtils.sum(windows.re()));
        double fullest = StatUtils.max(windows.filled());
        double[] inPhase = IntStream.range(0, count)
                .filter(k -> windows.filled()[k] >= LEAST_FILLED * fullest)
                .mapToDouble(k ->
                        (windows.re()[k] * Math.cos(mean) + windows.im()[k] * Math.sin(mean)) / windows.filled()[k])
                .toArray();
        double[] sizes = IntStream.range(0, count)
                .filter(k -> windows.filled()[k] >= LEAST_FILLED * fullest)
                .mapToDouble(k -> windows.weight(k) / windows.filled()[k])
                .toArray();
        return Quantiles.of(inPhase, 0.5) >= STEADY * StatUtils.mean(sizes);
    }

    private static double extent(HeightMap level, double azimuth) {
        return level.width() * Math.abs(Math.cos(azimuth)) + level.height() * Math.abs(Math.sin(azimuth));
    }

    private static Windows windows(
            int count, HeightMap level, SpatialFrequency wave, double azimuth, double step, boolean across) {
        Windows windows = new Windows(new double[count], new double[count], new double[count]);
        double alongX = Math.cos(azimuth);
        double alongY = Math.sin(azimuth);
        double breadth = extent(level, azimuth + 0.5 * Math.PI);
        double start = -0.5 * extent(level, azimuth);
        double window = WINDOW_PERIODS * wave.period();
        double[] cosines = new double[count];
        double[] sines = new double[count];
        Arrays.setAll(cosines, k -> Math.cos(2 * Math.PI * k * step / window));
        Arrays.setAll(sines, k -> Math.sin(2 * Math.PI * k * step / window));
        for (int row = 0; row < level.rows(); row++) {
            double y = (0.5 * level.rows() - row - 0.5) * level.pitchY();
            for (int column = 0; column < level.columns(); column++) {
                double x = (column + 0.5 - 0.5 * level.columns()) * level.pitchX();
                double place = x * alongX + y * alongY - start;
                // Heights fade out towards the borders along the lines, so that cut-off periods add no overtones.
                double fade = across ? Math.cos(Math.PI * (y * alongX - x * alongY) / breadth) : 1;
                double height = fade * fade * level.at(column, row);
                double angle = -2 * Math.PI * (wave.x() * x + wave.y() * y);
                double re = height * Math.cos(angle);
                double im = height * Math.sin(angle);
                double cosine = Math.cos(2 * Math.PI * place / window);
                double sine = Math.sin(2 * Math.PI * place / window);
                int newest = Math.min(count - 1, (int) (place / step));
                for (int k = newest; k >= 0 && k * step > place - window; k--) {
                    double hann = 0.5 - 0.5 * (cosine * cosines[k] + sine * sines[k]);
                    windows.re()[k] += hann * re;
                    windows.im()[k] += hann * im;
                    windows.filled()[k] += hann;
                }
            }
        }
        return windows;
    }

    /**
     * Weighted least squares with the larger error: of independent phases (stray lines, noise) or a random walk (varying gaps). The phases are
     * near one another, or continue each other, whichever fits better: a ridge between two windows may look like a lost period.
     */
    private static PhaseSlope fitted(Windows windows, int first, int last, double step) {
        double[] places = new double[(last - first) / PER_LENGTH + 1];
        double[] weights = new double[places.length];
        double[] near = new double[places.length];
        double[] following = new double[places.length];
        double[] phases = windows.phases();
        double re = 0;
        double im = 0;
        for (int k = 0; k < places.length; k++) {
            int i = first + k * PER_LENGTH;
            places[k] = i * step;
            weights[k] = windows.weight(i);
            following[k] = phases[i];
            re += windows.re()[i];
            im += windows.im()[i];
        }
        double mean = Math.atan2(im, re);
        Arrays.setAll(near, k -> mean + Math.IEEEremainder(following[k] - mean, 2 * Math.PI));
        Line one = Line.through(places, near, weights);
        Line other = Line.through(places, following, weights);
        return (one.squares <= other.squares ? one : other).slope(last * step);
    }

    /** Line through phases, radians, and its errors: weighted squares over the weights' spread, and squares of steps over the length's square. */
    private record Line(double slope, double squares, double white, double walk, double degrees) {
        static Line through(double[] places, double[] phases, double[] weights) {
            int count = places.length;
            double weight = StatUtils.sum(weights);
            double middle = 0;
            double mean = 0;
            for (int i = 0; i < count; i++) {
                middle += weights[i] * places[i] / weight;
                mean += weights[i] * phases[i] / weight;
            }
            double spread = 0;
            double sum = 0;
            for (int i = 0; i < count; i++) {
                spread += weights[i] * (places[i] - middle) * (places[i] - middle);
                sum += weights[i] * (places[i] - middle) * phases[i];
            }
            double slope = sum / spread;
            double squares = 0;
            double steps = 0;
            for (int i = 0; i < count; i++) {
                double rest = phases[i] - mean - slope * (places[i] - middle);
                squares += weights[i] * rest * rest;
                double next = i + 1 < count ? phases[i + 1] - phases[i] - slope * (places[i + 1] - places[i]) : 0;
                steps += next * next;
            }
            double degrees = count - 2.0;
            double walk = SMOOTHED * Math.sqrt(steps * (degrees + 1) / degrees) / (places[count - 1] - places[0]);
            return new Line(slope, squares, Math.sqrt(squares / degrees / spread), walk, degrees);
        }

        PhaseSlope slope(double length) {
            double seen = Math.max(white, walk) / (2 * Math.PI);
            double usual = USUAL / length;
            double all = degrees + USUAL_DEGREES;
            double error = Math.sqrt((degrees * seen * seen + USUAL_DEGREES * usual * usual) / all);
            return new PhaseSlope(slope / (2 * Math.PI), GratingPeriod.student(all) * error);
        }
    }

    /**
     * Returns a correction of the frequency along y, cycles per meter: the median of the phase's steps between bands of rows, of which a scanner
     * that slips changes few; 0 for fewer than three bands or periods along a row.
     */
    static double byRows(HeightMap level, SpatialFrequency wave) {
        int lag = Math.max(1, level.rows() / BANDS);
        int bands = level.rows() / lag;
        if (bands < 3 || Math.abs(wave.x()) * level.width() < FEWEST_IN_A_ROW) {
            return 0;
        }
        double[] phases = new double[bands];
        for (int band = 0; band < bands; band++) {
            double re = 0;
            double im = 0;
            for (int row = band * lag; row < (band + 1) * lag; row++) {
                for (int column = 0; column < level.columns(); column++) {
                    double hann = Math.sin(Math.PI * (column + 0.5) / level.columns());
                    double angle =
                            -2 * Math.PI * (wave.x() * column * level.pitchX() - wave.y() * row * level.pitchY());
                    re += hann * hann * level.at(column, row) * Math.cos(angle);
                    im += hann * hann * level.at(column, row) * Math.sin(angle);
                }
            }
            phases[band] = Math.atan2(im, re);
        }
        double[] steps = new double[bands - 1];
        // Rows run downwards, y upwards.
        Arrays.setAll(steps, i -> Math.IEEEremainder(phases[i] - phases[i + 1], 2 * Math.PI));
        Arrays.sort(steps);
        return steps[steps.length / 2] / (2 * Math.PI * lag * level.pitchY());
    }
}
