package sunbeam.precompute.analysis;

import java.util.function.IntToDoubleFunction;
import sunbeam.precompute.numerics.UnitCircle;
import sunbeam.precompute.patch.HeightMap;

/**
 * Heights times exp(-2 pi i f r), less their tilt and bow: a wave of frequency f stands still in it. Samples finer than an
 * eighth of a period are averaged first. The surface of second degree is fitted together with the wave, because one fitted
 * to a few periods alone would take some of the wave with it.
 */
final class DemodulatedHeights {
    // Per period; the averages of that many damp the wave by less than 3 % and shift it by nothing.
    private static final int FEWEST_SAMPLES = 8;
    // Of a direction's sine or cosine; below it, a row lies in the window with all its length or with none.
    private static final double LEAST_LEAN = 1e-9;

    private final int columns;
    private final int rows;
    private final double pitchX;
    private final double pitchY;
    private final double[] heights;
    private final double[] real;
    private final double[] imaginary;

    private DemodulatedHeights(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        this.columns = columns;
        this.rows = rows;
        this.pitchX = pitchX;
        this.pitchY = pitchY;
        this.heights = heights;
        this.real = new double[heights.length];
        this.imaginary = new double[heights.length];
    }

    /**
     * Demodulates a map without missing samples.
     *
     * @param frequencyX cycles per metre
     * @param frequencyY cycles per metre, upwards
     */
    static DemodulatedHeights of(HeightMap map, double frequencyX, double frequencyY) {
        double period = 1 / Math.hypot(frequencyX, frequencyY);
        int acrossX = averaged(period, map.pitchX(), map.columns());
        int acrossY = averaged(period, map.pitchY(), map.rows());
        DemodulatedHeights result = new DemodulatedHeights(
                map.columns() / acrossX,
                map.rows() / acrossY,
                map.pitchX() * acrossX,
                map.pitchY() * acrossY,
                averages(map, acrossX, acrossY));
        BowFit.AxisWaves alongX = wave(result.columns, result.width(), frequencyX, result::x);
        BowFit.AxisWaves alongY = wave(result.rows, result.height(), frequencyY, result::y);
        result.subtractBow(alongX, alongY);
        result.demodulate(alongX, alongY);
        return result;
    }

    private static int averaged(double period, double pitch, int count) {
        return Math.max(1, Math.min(count, (int) Math.floor(period / (FEWEST_SAMPLES * pitch))));
    }

    private static double[] averages(HeightMap map, int acrossX, int acrossY) {
        int columns = map.columns() / acrossX;
        int rows = map.rows() / acrossY;
        double[] averages = new double[columns * rows];
        double offset = map.at(0, 0);
        for (int row = 0; row < rows * acrossY; row++) {
            for (int column = 0; column < columns * acrossX; column++) {
                averages[row / acrossY * columns + column / acrossX] += map.at(column, row) - offset;
            }
        }
        for (int i = 0; i < averages.length; i++) {
            averages[i] /= (double) acrossX * acrossY;
        }
        return averages;
    }

    private void subtractBow(BowFit.AxisWaves alongX, BowFit.AxisWaves alongY) {
        double[] bow = new BowFit(alongX, alongY).coefficients(heights);
        for (int row = 0, i = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++, i++) {
                heights[i] -= BowFit.surface(bow, alongX.places()[column], alongY.places()[row]);
            }
        }
    }

    private void demodulate(BowFit.AxisWaves alongX, BowFit.AxisWaves alongY) {
        for (int row = 0, i = 0; row < rows; row++) {
            double cosineY = alongY.cosines()[row];
            double sineY = alongY.sines()[row];
            for (int column = 0; column < columns; column++, i++) {
                double cosineX = alongX.cosines()[column];
                double sineX = alongX.sines()[column];
                real[i] = heights[i] * (cosineX * cosineY - sineX * sineY);
                imaginary[i] = -heights[i] * (sineX * cosineY + cosineX * sineY);
            }
        }
    }

    private static BowFit.AxisWaves wave(int count, double extent, double frequency, IntToDoubleFunction metres) {
        double[] places = new double[count];
        double[] cosines = new double[count];
        double[] sines = new double[count];
        for (int i = 0; i < count; i++) {
            double place = metres.applyAsDouble(i);
            places[i] = place / extent;
            sines[i] = 2 * Math.PI * frequency * place;
        }
        UnitCircle.points(sines, cosines);
        return new BowFit.AxisWaves(places, cosines, sines);
    }

    /** Extent along x, metres. */
    double width() {
        return columns * pitchX;
    }

    /** Extent along y, metres. */
    double height() {
        return rows * pitchY;
    }

    /** Position of a column's middle from the patch's, metres. */
    private double x(int column) {
        return (column - 0.5 * (columns - 1)) * pitchX;
    }

    /** Position of a row's middle from the patch's, metres, upwards. */
    private double y(int row) {
        return (0.5 * (rows - 1) - row) * pitchY;
    }

    /**
     * The wave's complex amplitude around a place: the mean under a spline along the wave and a Hann window across it.
     * Boxes of one period, folded with each other, leave no trace of a constant, the mirror frequency and the overtones;
     * two of them none of a slope, three none of a bow, of which waviness consists at this scale.
     *
     * @param s metres along the direction from the patch's middle
     * @param t metres across it
     * @param frame direction and windows
     * @param amplitude overwritten with real and imaginary part
     */
    void amplitude(double s, double t, Frame frame, double[] amplitude) {
        double centreX = s * frame.cosine() - t * frame.sine();
        double centreY = s * frame.sine() + t * frame.cosine();
        double reachX = 0.5 * (Math.abs(frame.cosine()) * frame.along() + Math.abs(frame.sine()) * frame.across());
        double reachY = 0.5 * (Math.abs(frame.sine()) * frame.along() + Math.abs(frame.cosine()) * frame.across());
        int firstColumn = Math.max(0, (int) Math.ceil((centreX - reachX) / pitchX + 0.5 * (columns - 1)));
        int lastColumn = Math.min(columns - 1, (int) Math.floor((centreX + reachX) / pitchX + 0.5 * (columns - 1)));
        int firstRow = Math.max(0, (int) Math.ceil(0.5 * (rows - 1) - (centreY + reachY) / pitchY));
        int lastRow = Math.min(rows - 1, (int) Math.floor(0.5 * (rows - 1) - (centreY - reachY) / pitchY));
        double sumReal = 0;
        double sumImaginary = 0;
        double weights = 0;
        // By a step to the next column, the angle of the cosine across turns by this.
        double turn = -Math.PI * pitchX * frame.sine() / frame.across();
        double turnCosine = Math.cos(turn);
        double turnSine = Math.sin(turn);
        for (int row = firstRow; row <= lastRow; row++) {
            double dy = y(row) - centreY;
            int first = Math.max(firstColumn, column(centreX + frame.firstX(dy), true));
            int last = Math.min(lastColumn, column(centreX + frame.lastX(dy), false));
            double dx = x(first) - centreX;
            double angle = Math.PI * (dy * frame.cosine() - dx * frame.sine()) / frame.across();
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            for (int column = first; column <= last; column++, dx += pitchX) {
                double weight = spline((dx * frame.cosine() + dy * frame.sine()) / frame.along(), frame.boxes())
                        * cosine
                        * cosine;
                sumReal += weight * real[row * columns + column];
                sumImaginary += weight * imaginary[row * columns + column];
                weights += weight;
                double turned = cosine * turnCosine - sine * turnSine;
                sine = cosine * turnSine + sine * turnCosine;
                cosine = turned;
            }
        }
        amplitude[0] = weights > 0 ? sumReal / weights : 0;
        amplitude[1] = weights > 0 ? sumImaginary / weights : 0;
    }

    /** Two boxes folded, a triangle; or three, a bell of parabolas; 0 from half a window away. */
    private static double spline(double windows, int boxes) {
        double away = Math.abs(windows) * boxes;
        if (away >= 0.5 * boxes) {
            return 0;
        }
        double rest = 0.5 * boxes - away;
        if (boxes == 2) {
            return rest;
        }
        return away < 0.5 ? 0.75 - away * away : 0.5 * rest * rest;
    }

    /** The first column at or after a place, or the last at or before it. */
    private int column(double x, boolean after) {
        double column = x / pitchX + 0.5 * (columns - 1);
        return (int) Math.max(-1, Math.min(columns, after ? Math.ceil(column) : Math.floor(column)));
    }

    /** Whether a window's whole length, and half of its width, which has nine tenths of its weight, lie on the patch. */
    boolean covers(double s, double t, Frame frame) {
        double x = Math.abs(s * frame.cosine() - t * frame.sine());
        double y = Math.abs(s * frame.sine() + t * frame.cosine());
        double reachX = Math.abs(frame.cosine()) * 0.5 * frame.along() + Math.abs(frame.sine()) * 0.25 * frame.across();
        double reachY = Math.abs(frame.sine()) * 0.5 * frame.along() + Math.abs(frame.cosine()) * 0.25 * frame.across();
        double slack = 1e-9 * (width() + height());
        return x + reachX <= 0.5 * width() + slack && y + reachY <= 0.5 * height() + slack;
    }

    /**
     * A direction and the windows along and across it.
     *
     * @param cosine of the direction
     * @param sine of the direction
     * @param along full length of the window along it, metres
     * @param across full length across, metres
     * @param boxes of one period each, of which the one along is folded: 2 or 3
     */
    record Frame(double cosine, double sine, double along, double across, int boxes) {
        /** Where a row so far above the centre enters the window, metres from the centre. */
        double firstX(double dy) {
            return Math.max(
                    -reach(cosine, along) - shift(cosine, dy * sine), -reach(sine, across) + shift(sine, dy * cosine));
        }

        /** Where it leaves it. */
        double lastX(double dy) {
            return Math.min(
                    reach(cosine, along) - shift(cosine, dy * sine), reach(sine, across) + shift(sine, dy * cosine));
        }

        /** Half of what a strip cuts out of a row that runs at an angle to its width. */
        private static double reach(double lean, double width) {
            return Math.abs(lean) < LEAST_LEAN ? Double.POSITIVE_INFINITY : 0.5 * width / Math.abs(lean);
        }

        private static double shift(double lean, double away) {
            return Math.abs(lean) < LEAST_LEAN ? 0 : away / lean;
        }
    }
}
