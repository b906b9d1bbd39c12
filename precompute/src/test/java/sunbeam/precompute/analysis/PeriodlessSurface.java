package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Leveling;

/** Randomly drawn noisy scans of surfaces without a period, leveled by their plane as commands do. */
enum PeriodlessSurface {
    WHITE,
    CORRELATED,
    FRACTAL,
    DRIFT,
    ONE_STEP,
    TWO_STEPS,
    COLUMNS;

    private static final double PITCH = 80e-9;

    /** 96 to 160 samples a side. */
    @SuppressWarnings("EnumOrdinal") // only the seed rests on it
    HeightMap draw(long seed) {
        SplittableRandom random = new SplittableRandom(1000L * ordinal() + seed);
        int columns = 96 + random.nextInt(65);
        int rows = 96 + random.nextInt(65);
        double[] heights = heights(columns, rows, random);
        double scale = Arrays.stream(heights).map(Math::abs).max().orElseThrow();
        double noise = Math.pow(10, -3 + 2 * random.nextDouble());
        Arrays.setAll(heights, i -> 1e-7 * (heights[i] / scale + noise * random.nextGaussian()));
        return Leveling.PLANE.apply(new HeightMap(columns, rows, PITCH, PITCH, heights));
    }

    private double[] heights(int columns, int rows, SplittableRandom random) {
        return switch (this) {
            case WHITE -> smoothed(columns, rows, 0, random);
            case CORRELATED -> smoothed(columns, rows, 1 + random.nextInt(8), random);
            case FRACTAL -> fractal(columns, rows, 1 + random.nextDouble(), random);
            case DRIFT -> along(columns, rows, random.nextDouble() * Math.PI, drift(random));
            case ONE_STEP -> along(columns, rows, random.nextDouble() * Math.PI, steps(1, random));
            case TWO_STEPS -> along(columns, rows, random.nextDouble() * Math.PI, steps(2, random));
            case COLUMNS -> {
                double[] profile = smoothed(columns, 1, random.nextInt(4), random);
                yield Surfaces.sampled(columns, rows, PITCH, (column, row) -> profile[column])
                        .heights();
            }
        };
    }

    private static double[] along(int columns, int rows, double angle, DoubleUnaryOperator profile) {
        double reach = Math.abs(Math.cos(angle)) + Math.abs(Math.sin(angle));
        return Surfaces.sampled(columns, rows, PITCH, (column, row) -> {
                    double x = 2.0 * column / columns - 1;
                    double y = 2.0 * row / rows - 1;
                    return profile.applyAsDouble((x * Math.cos(angle) + y * Math.sin(angle)) / reach);
                })
                .heights();
    }

    private static DoubleUnaryOperator steps(int count, SplittableRandom random) {
        boolean up = random.nextBoolean();
        double[] widths = random.doubles(count + 1, 1, 3).toArray();
        double total = Arrays.stream(widths).sum();
        return t -> {
            double place = (t + 1) / 2 * total;
            int step = 0;
            for (int i = 0; i < count && place > widths[i]; i++) {
                place -= widths[i];
                step++;
            }
            return up ? step : step % 2;
        };
    }

    /** Four slow waves, the slowest highest. */
    private static DoubleUnaryOperator drift(SplittableRandom random) {
        double[] phases = random.doubles(4, 0, 2 * Math.PI).toArray();
        double[] turns = random.doubles(4, 0.2, 2.5).toArray();
        return t -> IntStream.range(0, turns.length)
                .mapToDouble(i -> Math.sin(Math.PI * turns[i] * t + phases[i]) / turns[i])
                .sum();
    }

    /** White noise under three boxes of 2 r + 1 samples along each axis, to a variance of about 1. */
    private static double[] smoothed(int columns, int rows, int radius, SplittableRandom random) {
        double[] heights = random.doubles((long) columns * rows, -1, 1).toArray();
        for (int pass = 0; pass < (radius > 0 ? 3 : 0); pass++) {
            heights = boxed(boxed(heights, columns, rows, radius, 0), columns, rows, 0, radius);
        }
        double square =
                Math.sqrt(Arrays.stream(heights).map(h -> h * h).average().orElseThrow());
        return Arrays.stream(heights).map(h -> h / square).toArray();
    }

    private static double[] boxed(double[] heights, int columns, int rows, int alongX, int alongY) {
        double[] means = new double[heights.length];
        for (int i = 0; i < heights.length; i++) {
            int column = i % columns;
            int row = i / columns;
            for (int y = Math.max(0, row - alongY); y <= Math.min(rows - 1, row + alongY); y++) {
                for (int x = Math.max(0, column - alongX); x <= Math.min(columns - 1, column + alongX); x++) {
                    means[i] += heights[y * columns + x];
                }
            }
        }
        return means;
    }

    private static double[] fractal(int columns, int rows, double power, SplittableRandom random) {
        double[] heights = new double[columns * rows];
        for (int wave = 0; wave < 400; wave++) {
            // Equally many waves in each octave of frequency from half a turn to thirty.
            double turns = 0.5 * Math.pow(60, random.nextDouble());
            double angle = Math.PI * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            double amplitude = random.nextGaussian() * Math.pow(turns, -power);
            double stepX = 2 * Math.PI * turns * Math.cos(angle) / columns;
            double stepY = 2 * Math.PI * turns * Math.sin(angle) / columns;
            for (int i = 0; i < heights.length; i++) {
                int row = i / columns;
                heights[i] += amplitude * Math.cos(phase + stepX * (i % columns) + stepY * row);
            }
        }
        return heights;
    }
}
