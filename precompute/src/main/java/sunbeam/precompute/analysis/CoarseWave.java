package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import sunbeam.precompute.optics.HeightMap;

/**
 * Wave so long that a scan holds fewer than three periods: leveling bends it and its spectral line is that of waviness. A plane, a bow and the
 * wave are fitted to the heights together, by least squares.
 */
record CoarseWave(List<double[]> levels, double[] rest, int columns, int rows) {
    private static final int GRID = 24;
    // Periods along a side of the scan, and their step: an eighth of a period at either border.
    private static final double MOST = 4;
    private static final double FEWEST = 3;
    private static final double STEP = 0.25;
    // Share of the variance beside plane and bow; at most 4 of 168 drawn surfaces without order have it.
    private static final double LEAST_SHARE = 0.8;
    // A term of the level that repeats others, as all along y do in a profile, leaves rounding alone.
    private static final double ROUNDING = 1e-9;

    /** Returns the best of the accepted waves if it fits less than three times and is most of the relief. */
    static Optional<SpatialFrequency> in(HeightMap scan, Predicate<SpatialFrequency> which) {
        int columns = Math.min(GRID, scan.columns());
        int rows = Math.min(GRID, scan.rows());
        double[] heights = new double[columns * rows];
        double[] counts = new double[columns * rows];
        for (int i = 0; i < scan.heights().length; i++) {
            int row = (int) ((long) (i / scan.columns()) * rows / scan.rows());
            int place = row * columns + (int) ((long) (i % scan.columns()) * columns / scan.columns());
            heights[place] += scan.heights()[i] - scan.heights()[0];
            counts[place]++;
        }
        Arrays.setAll(heights, i -> heights[i] / counts[i]);
        CoarseWave fit = new CoarseWave(new ArrayList<>(), heights, columns, rows);
        for (int power = 0; power < 6; power++) {
            int term = power;
            fit.level(fit.sampled((x, y) -> new double[] {1, x, y, x * x, x * y, y * y}[term]));
        }
        double all = dot(fit.rest, fit.rest);
        double best = LEAST_SHARE * all;
        Optional<SpatialFrequency> found = Optional.empty();
        int reachX = columns > 1 ? (int) (MOST / STEP) : 0;
        int reachY = rows > 1 ? (int) (MOST / STEP) : 0;
        for (int jy = -reachY; jy <= reachY; jy++) {
            for (int jx = 0; jx <= reachX; jx++) {
                SpatialFrequency wave = new SpatialFrequency(jx * STEP / scan.width(), jy * STEP / scan.height());
                if (wave.length() > 0 && wave.periodsIn(scan) >= 1 && which.test(wave)) {
                    double explained = fit.explained(jx * STEP, jy * STEP);
                    if (explained > best) {
                        best = explained;
                        found = Optional.of(wave);
                    }
                }
            }
        }
        return found.filter(wave -> wave.periodsIn(scan) < FEWEST);
    }

    private interface Term {
        double at(double x, double y);
    }

    /** Positions -0.5..0.5 of the scan's sides, y upwards. */
    private double[] sampled(Term term) {
        double[] values = new double[columns * rows];
        for (int row = 0, i = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++, i++) {
                values[i] = term.at((column + 0.5) / columns - 0.5, 0.5 - (row + 0.5) / rows);
            }
        }
        return values;
    }

    private void level(double[] term) {
        double before = dot(term, term);
        levels.forEach(level -> subtract(term, level));
        double size = Math.sqrt(dot(term, term));
        if (size * size > ROUNDING * before) {
            Arrays.setAll(term, i -> term[i] / size);
            levels.add(term);
            subtract(rest, term);
        }
    }

    /** Returns the sum of squares that a wave of some periods along x and y explains. */
    private double explained(double alongX, double alongY) {
        double[] cosine = sampled((x, y) -> Math.cos(2 * Math.PI * (alongX * x + alongY * y)));
        double[] sine = sampled((x, y) -> Math.sin(2 * Math.PI * (alongX * x + alongY * y)));
        levels.forEach(level -> {
            subtract(cosine, level);
            subtract(sine, level);
        });
        double cc = dot(cosine, cosine);
        double cs = dot(cosine, sine);
        double ss = dot(sine, sine);
        double c = dot(cosine, rest);
        double s = dot(sine, rest);
        double determinant = cc * ss - cs * cs;
        return determinant > ROUNDING * cc * ss ? (c * c * ss - 2 * c * s * cs + s * s * cc) / determinant : 0;
    }

    private static void subtract(double[] from, double[] unit) {
        double size = dot(from, unit);
        Arrays.setAll(from, i -> from[i] - size * unit[i]);
    }

    static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
