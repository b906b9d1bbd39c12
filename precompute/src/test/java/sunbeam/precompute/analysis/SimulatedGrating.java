package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

/** Kinds of randomly drawn scans of gratings with known periods. */
enum SimulatedGrating {
    CLEAN,
    STRAYED,
    GAPS,
    WARPED,
    NOISY,
    TWO,
    CHIRPED,
    ROWS;

    FaultyScan draw(long seed) {
        SplittableRandom random =
                new SplittableRandom(seed * 7919 + List.of(values()).indexOf(this));
        double width = 5e-6 * Math.pow(16, random.nextDouble());
        double longest = Math.min(5e-6, width / 4.5);
        double period = 0.6e-6 * Math.pow(longest / 0.6e-6, random.nextDouble());
        double pitch = Math.max(period / (10 + 10 * random.nextDouble()), width / 700);
        int columns = (int) Math.round(width / pitch);
        int rows = Math.max(1, (int) (columns * (0.2 + 0.8 * random.nextDouble())));
        double disorder = 0.15 * random.nextDouble();
        int shape = random.nextInt(3);
        double azimuth = random.nextBoolean() ? 0 : Math.toRadians(-80 + 160 * random.nextDouble());
        double depth = 50e-9 + 200e-9 * random.nextDouble();
        double tilt = random.nextBoolean() ? 0 : 0.2 * (random.nextDouble() - 0.5);
        double noise = this == NOISY ? depth * random.nextDouble() : 0.01 * depth;
        double ratio = 1.08 + 0.4 * random.nextDouble();
        double growth = 1.02 + 0.5 * random.nextDouble();
        double[] lines = lines(random, 3 * (int) Math.ceil(2 * width / period), disorder);
        double start = random.nextDouble();
        int bands = this == ROWS ? Math.max(1, (int) Math.round(rows * pitch / (3 * period))) : 1;
        double[][] bandLines = new double[bands][];
        Arrays.setAll(bandLines, i -> this == ROWS ? GAPS.lines(random, lines.length, disorder) : lines);
        double angle = this == ROWS ? 0 : azimuth;
        HeightMap map = Surfaces.sampled(columns, rows, pitch, (column, row) -> {
            double x = (column - 0.5 * columns) * pitch;
            double y = (0.5 * rows - row) * pitch;
            double s = x * Math.cos(angle) + y * Math.sin(angle);
            double height;
            if (this == TWO) {
                double other = 0.6 + 0.4 * disorder / 0.15;
                height = 0.5 * Math.cos(2 * Math.PI * s / period)
                        + 0.5 * other * Math.cos(2 * Math.PI * (s / (period * ratio) + start));
            } else if (this == CHIRPED) {
                double change = (1 / growth - 1) / width;
                height = wave(s / period * (1 + 0.5 * change * s) + start, shape);
            } else {
                height = wave(phase(bandLines[Math.min(bands - 1, row * bands / rows)], s / period) + start, shape);
            }
            return depth * height + tilt * x + noise * random.nextGaussian();
        });
        double[] truths = this == TWO ? new double[] {period, period * ratio} : new double[] {period};
        return new FaultyScan(map, truths, this + " seed " + seed);
    }

    private double[] lines(SplittableRandom random, int count, double disorder) {
        double[] lines = new double[count];
        double walk = 0;
        double velocity = 0;
        for (int i = 0; i < count; i++) {
            double strayed = this == GAPS || this == STRAYED || this == WARPED ? disorder * random.nextGaussian() : 0;
            velocity = this == WARPED ? 0.6 * velocity + 0.4 * strayed : strayed;
            walk = this == STRAYED ? strayed : walk + velocity;
            lines[i] = i - 0.5 * count + walk;
        }
        Arrays.sort(lines);
        return lines;
    }

    /** Number of lines passed, including the part of the current gap. */
    private static double phase(double[] lines, double place) {
        int found = Arrays.binarySearch(lines, place);
        int low = Math.max(0, Math.min(lines.length - 2, found < 0 ? -found - 2 : found));
        return low + (place - lines[low]) / (lines[low + 1] - lines[low]);
    }

    private static double wave(double turns, int shape) {
        double part = turns - Math.floor(turns);
        return switch (shape) {
            case 0 -> 0.5 * Math.cos(2 * Math.PI * part);
            case 1 -> part - 0.5;
            default -> Math.exp(-Math.pow((part - 0.5) / 0.15, 2));
        };
    }
}
