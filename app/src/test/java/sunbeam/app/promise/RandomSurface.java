package sunbeam.app.promise;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import sunbeam.precompute.optics.HeightMap;

/** Kinds of made-up surfaces, drawn with random shapes and sizes. */
enum RandomSurface {
    FLAT,
    STEP,
    DUST,
    SINUSOID,
    LAMELLAR,
    BLAZE,
    WAVES,
    NOISE,
    ROUGH,
    FACET,
    CHIRP,
    FAINT;

    private static final double SMALLEST_RELIEF = 5e-9;
    private static final double LARGEST_RELIEF = 5e-6;

    /**
     * A surface of this kind.
     *
     * @param mostSamples along a side
     * @param pitch of the samples along x, meters; along y it is up to twice as long or as short
     * @param longest side, meters
     */
    HeightMap draw(SplittableRandom random, int mostSamples, double pitch, double longest) {
        double pitchY = random.nextBoolean() ? pitch : pitch * Math.pow(2, random.nextDouble(-1, 1));
        int columns = side(random, Math.min(mostSamples, (int) (longest / pitch)));
        int rows = random.nextInt(4) == 0 ? 1 : side(random, Math.min(mostSamples, (int) (longest / pitchY)));
        double relief = SMALLEST_RELIEF * Math.pow(LARGEST_RELIEF / SMALLEST_RELIEF, random.nextDouble());
        int periods = random.nextInt(1, Math.max(2, columns / 4 + 1));
        double duty = random.nextDouble(0.2, 0.8);
        double grain = random.nextDouble(0.05, 0.3);
        double middleX = random.nextDouble();
        double middleY = random.nextDouble();
        DoubleBinaryOperator heights = switch (this) {
            case FLAT -> (x, y) -> 0;
            case STEP -> (x, y) -> x < duty ? relief : 0;
            case DUST -> (x, y) -> Math.hypot(x - middleX, y - middleY) < grain ? relief : 0;
            case SINUSOID -> (x, y) -> 0.5 * relief * Math.sin(2 * Math.PI * periods * x);
            case LAMELLAR -> (x, y) -> periods * x % 1 < duty ? relief : 0;
            case BLAZE -> (x, y) -> relief * (periods * x % 1);
            case FACET -> (x, y) -> relief * (duty * x + grain * y);
            case CHIRP -> (x, y) -> 0.5 * relief * Math.sin(2 * Math.PI * periods * x * (1 + x));
            case WAVES -> waves(random, relief);
            case NOISE, ROUGH -> (x, y) -> random.nextDouble() * relief;
            case FAINT -> (x, y) -> random.nextDouble() * 5e-9;
        };
        return smoothed(of(columns, rows, pitch, pitchY, heights), this == ROUGH ? 3 : this == FAINT ? 1 : 0);
    }

    /** Two samples or more, small and large sides equally often. */
    private static int side(SplittableRandom random, int most) {
        return (int) (2 * Math.pow(Math.max(1, most / 2.0), random.nextDouble()));
    }

    /** Heights in meters of x and y in 0..1. */
    static HeightMap of(int columns, int rows, double pitch, double pitchY, DoubleBinaryOperator height) {
        double[] heights = new double[columns * rows];
        Arrays.setAll(heights, i -> {
            int row = i / columns;
            return height.applyAsDouble(i % columns / (double) columns, (double) row / rows);
        });
        return new HeightMap(columns, rows, pitch, pitchY, heights);
    }

    private static DoubleBinaryOperator waves(SplittableRandom random, double relief) {
        double[] phases = random.doubles(3, 0, 2 * Math.PI).toArray();
        int[] orders = random.ints(6, -3, 4).toArray();
        return (x, y) -> {
            double sum = 0;
            for (int i = 0; i < 3; i++) {
                sum += Math.sin(2 * Math.PI * (orders[2 * i] * x + orders[2 * i + 1] * y) + phases[i]);
            }
            return relief * sum / 6;
        };
    }

    /** Means of neighbors, again and again; periodic. */
    private static HeightMap smoothed(HeightMap map, int times) {
        int columns = map.columns();
        int rows = map.rows();
        HeightMap result = map;
        for (int pass = 0; pass < times; pass++) {
            double[] heights = new double[columns * rows];
            for (int i = 0; i < heights.length; i++) {
                int column = i % columns;
                int row = i / columns;
                double sum = 0;
                for (int d = 0; d < 9; d++) {
                    sum += result.at(Math.floorMod(column + d % 3 - 1, columns), Math.floorMod(row + d / 3 - 1, rows));
                }
                heights[i] = sum / 9;
            }
            result = new HeightMap(columns, rows, map.pitchX(), map.pitchY(), heights);
        }
        return result;
    }
}
