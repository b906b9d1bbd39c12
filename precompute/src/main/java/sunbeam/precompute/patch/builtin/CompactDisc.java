package sunbeam.precompute.patch.builtin;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.HeightMap;

/**
 * Data side of a compact disc without lacquer (IEC 60908): straight tracks along y with pits and lands in turn, each 3 to 11 channel bits
 * long. Their lengths n are random, with probabilities proportional to 0.7^n, in place of coded data. The surface is regular across the
 * tracks and random along them.
 */
final class CompactDisc {
    private static final int TRACKS = 32;
    private static final double TRACK_PITCH = 1.6e-6;
    private static final double SIDE = TRACKS * TRACK_PITCH;
    /** 50 nm apart. */
    private static final int SAMPLES = 1024;

    private static final double PITCH = SIDE / SAMPLES;
    /** 278 nm per bit, as at a speed of 1.2 m/s and a rate of 4.3218 MHz. */
    private static final int CHANNEL_BITS = 184;
    /** At half depth, meters. */
    private static final double PIT_WIDTH = 500e-9;

    private static final double PIT_DEPTH = 110e-9;
    /** Width of the walls, whose profile is a cosine, meters. */
    private static final double WALL_WIDTH = 150e-9;

    // Channel bits.
    private static final int SHORTEST_RUN = 3;
    private static final int LONGEST_RUN = 11;
    private static final double RUN_RATIO = 0.7;
    private static final int SEED = 3;

    private CompactDisc() {}

    static HeightMap generate() {
        SeededNoise noise = new SeededNoise(SEED);
        double[] heights = new double[SAMPLES * SAMPLES];
        for (int track = 0; track < TRACKS; track++) {
            double position = noise.uniform() * SIDE;
            boolean pit = true;
            for (int run : runs(noise)) {
                double length = run * SIDE / CHANNEL_BITS;
                if (pit) {
                    sink(heights, (track + 0.5) * TRACK_PITCH, position, length);
                }
                pit = !pit;
                position += length;
            }
        }
        return new HeightMap(SAMPLES, SAMPLES, PITCH, PITCH, heights);
    }

    /** Lengths of pits and lands in turn, in channel bits, fill the track exactly, so that it is periodic. */
    private static List<Integer> runs(SeededNoise noise) {
        List<Integer> runs = new ArrayList<>();
        int sum = 0;
        // About one try in ten ends exactly with the track and with a land.
        while (sum != CHANNEL_BITS || runs.size() % 2 != 0) {
            if (sum >= CHANNEL_BITS) {
                runs.clear();
                sum = 0;
            }
            int run = run(noise);
            runs.add(run);
            sum += run;
        }
        return runs;
    }

    private static int run(SeededNoise noise) {
        int run = SHORTEST_RUN;
        while (noise.uniform() < RUN_RATIO) {
            run = run == LONGEST_RUN ? SHORTEST_RUN : run + 1;
        }
        return run;
    }

    /** Sinks a bar with round ends, which wraps around the patch; meters. */
    private static void sink(double[] heights, double center, double start, double length) {
        double reach = (PIT_WIDTH + WALL_WIDTH) / 2;
        double middle = start + length / 2;
        double straight = Math.max(0, (length - PIT_WIDTH) / 2);
        int firstRow = (int) Math.floor((start - WALL_WIDTH) / PITCH);
        int lastRow = (int) Math.ceil((start + length + WALL_WIDTH) / PITCH);
        int firstColumn = (int) Math.floor((center - reach) / PITCH);
        int lastColumn = (int) Math.ceil((center + reach) / PITCH);
        for (int row = firstRow; row <= lastRow; row++) {
            double beyond = Math.max(0, Math.abs(row * PITCH - middle) - straight);
            for (int column = firstColumn; column <= lastColumn; column++) {
                double outside = Math.hypot(column * PITCH - center, beyond) - PIT_WIDTH / 2;
                int index = Math.floorMod(row, SAMPLES) * SAMPLES + Math.floorMod(column, SAMPLES);
                heights[index] = Math.min(heights[index], -PIT_DEPTH * depthAt(outside));
            }
        }
    }

    /** Relative depth at a signed distance in meters from the contour of half depth. */
    private static double depthAt(double outside) {
        double z = Math.max(-1, Math.min(1, 2 * outside / WALL_WIDTH));
        return (1 - StrictMath.sin(StrictMath.PI / 2 * z)) / 2;
    }
}
