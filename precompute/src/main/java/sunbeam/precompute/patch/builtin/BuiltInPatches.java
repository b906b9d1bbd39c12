package sunbeam.precompute.patch.builtin;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Generators of the built-in patches: periodic, equal on every run. Parameters and sources: docs/guide.md. */
public final class BuiltInPatches {
    // Meters, as in the thesis.
    private static final double PERIOD = 2.5e-6;
    // The visible orders (up to 13 for 2.5 um and 380 nm) have no aliases.
    private static final int COLUMNS = 128;
    // Rows are equal and 78 nm apart, finer than a quarter of 380 nm.
    private static final int ROWS = 32;
    // A bump has this height and pitch (meters), and takes so many samples.
    private static final double BUMP_HEIGHT = 150e-9;
    private static final double BUMP_PITCH = 62.5e-9;
    private static final int BUMP_COLUMNS = 8;
    private static final int BUMP_ROWS = 16;
    private static final Map<String, Supplier<HeightMap>> GENERATORS = new LinkedHashMap<>();

    static {
        // Rises towards +x, so that light goes towards -x: order m has the power sinc^2(k w H / (2 pi) - m).
        GENERATORS.put("blaze", () -> grating(x -> 250e-9 * x));
        // Order m has the power J_m(k w amplitude)^2.
        GENERATORS.put("sinusoid", () -> grating(x -> 100e-9 * StrictMath.sin(2 * StrictMath.PI * x)));
        // Ridges of half the period have no even orders but 0; lambda / 4 at 550 nm darkens the mirror.
        GENERATORS.put("lamellar", () -> grating(x -> x < 0.5 ? 137.5e-9 : 0));
        GENERATORS.put("lattice", BuiltInPatches::lattice);
        GENERATORS.put("disc", CompactDisc::generate);
        GENERATORS.put("bumps", () -> bumps(1024, 1024, 5));
        GENERATORS.put("elaphe-like", () -> FingerSkin.ELAPHE.generate());
        GENERATORS.put("xenopeltis-like", () -> FingerSkin.XENOPELTIS.generate());
    }

    private BuiltInPatches() {}

    public static List<String> names() {
        return List.copyOf(GENERATORS.keySet());
    }

    public static HeightMap generate(String name) {
        return GENERATORS.get(name).get();
    }

    /** Hills and hollows in rows along both axes. */
    private static HeightMap lattice() {
        double[] heights = new double[ROWS * ROWS];
        Arrays.setAll(heights, i -> {
            int row = i / ROWS;
            return 150e-9 * sine(i % ROWS) * sine(row);
        });
        return new HeightMap(ROWS, ROWS, PERIOD / ROWS, PERIOD / ROWS, heights);
    }

    private static double sine(int sample) {
        return StrictMath.sin(2 * StrictMath.PI * (sample + 0.5) / ROWS);
    }

    /** Samples the profile at the middle of each interval of x in 0..1. */
    private static HeightMap grating(DoubleUnaryOperator profile) {
        double[] heights = new double[ROWS * COLUMNS];
        Arrays.setAll(heights, i -> profile.applyAsDouble((i % COLUMNS + 0.5) / COLUMNS));
        return new HeightMap(COLUMNS, ROWS, PERIOD / COLUMNS, PERIOD / ROWS, heights);
    }

    /**
     * Data side of a compact disc without lacquer (IEC 60908): straight tracks along y with pits and lands of 3 to 11 channel bits in turn,
     * whose random lengths n have probabilities proportional to 0.7^n.
     */
    private static final class CompactDisc {
        private static final int TRACKS = 32;
        private static final double TRACK_PITCH = 1.6e-6;
        private static final double SIDE = TRACKS * TRACK_PITCH;
        // 50 nm apart.
        private static final int SAMPLES = 1024;
        private static final double PITCH = SIDE / SAMPLES;
        // 278 nm per bit, as at a speed of 1.2 m/s and a rate of 4.3218 MHz.
        private static final int CHANNEL_BITS = 184;
        // At half depth, meters.
        private static final double PIT_WIDTH = 500e-9;
        private static final double PIT_DEPTH = 110e-9;
        // Walls with a cosine profile, meters.
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

        /** Lengths of pits and lands fill the track exactly, so that it is periodic. */
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

        /** Sinks a bar with round ends; lengths in meters. */
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
                    double wall = Math.max(-1, Math.min(1, 2 * outside / WALL_WIDTH));
                    int index = Math.floorMod(row, SAMPLES) * SAMPLES + Math.floorMod(column, SAMPLES);
                    heights[index] =
                            Math.min(heights[index], -PIT_DEPTH * (1 - StrictMath.sin(StrictMath.PI / 2 * wall)) / 2);
                }
            }
        }
    }

    /**
     * Flat bumps of the size that Stam chose (Diffraction Shaders, SIGGRAPH 1999), 0.15 um high, 0.5 um along x, 1 um along y, at independent,
     * uniformly random positions (shot noise). Heights of overlapping bumps add up. Bumps align with samples and wrap around the patch's edge.
     *
     * <p>Let p(s) = exp(i k w h(s)) be the phase factor, t = k w BUMP_HEIGHT, c = 1 - cos t. Let N be the number of bumps of area a on a patch of
     * area A, and g(r) the area of the intersection of a bump with itself shifted by r. The expected autocorrelation of p is
     *
     * <pre>mean of p(s) p*(s + r) = (1 - 2 c (a - g(r)) / A)^N</pre>
     *
     * because each bump changes the phase between the two positions with the probability 2 (a - g(r)) / A. For r beyond a bump's size, g is 0
     * and the autocorrelation constant: this is the light in the mirror direction. The Fourier transform of the rest is the halo. For sparse
     * bumps it is the power of one bump times their number, N (2 a sin(t / 2) sinc(fx 0.5 um) sinc(fy 1 um))^2 / A.
     *
     * @param samples samples per side, at least {@link #BUMP_ROWS}
     */
    static HeightMap bumps(int samples, int count, long seed) {
        SeededNoise noise = new SeededNoise(seed);
        double[] heights = new double[samples * samples];
        for (int bump = 0; bump < count; bump++) {
            int left = (int) (noise.uniform() * samples);
            int top = (int) (noise.uniform() * samples);
            for (int i = 0; i < BUMP_ROWS * BUMP_COLUMNS; i++) {
                heights[(top + i / BUMP_COLUMNS) % samples * samples + (left + i % BUMP_COLUMNS) % samples] +=
                        BUMP_HEIGHT;
            }
        }
        return new HeightMap(samples, samples, BUMP_PITCH, BUMP_PITCH, heights);
    }
}
