package sunbeam.precompute.patch.builtin;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.HeightMap;

/**
 * The data side of a compact disc, without its lacquer: straight tracks along y with pits of 3 to 11 channel bits,
 * alternating with lands of 3 to 11, as on a real disc (IEC 60908). That a run of n bits is drawn 0.7^n as often is a
 * stand-in for coded data. The tracks hold different
 * data, so there is order across them and none along them.
 *
 * @param tracks number of tracks; the square patch is {@code tracks * trackPitch} wide
 * @param samples samples along each side
 * @param trackPitch distance of the tracks in metres
 * @param channelBits number of bits along the patch; a bit is {@code tracks * trackPitch / channelBits} long
 * @param pitWidth width of a pit at half depth in metres
 * @param pitDepth depth of a pit in metres
 * @param wallWidth extent of a pit's wall in metres, across which the depth grows as a cosine
 * @param seed of the data
 */
public record CompactDisc(
        int tracks,
        int samples,
        double trackPitch,
        int channelBits,
        double pitWidth,
        double pitDepth,
        double wallWidth,
        long seed) {
    private static final int SHORTEST_RUN = 3;
    private static final int LONGEST_RUN = 11;
    private static final double RUN_RATIO = 0.7;

    public CompactDisc {
        Parameters.requireSamples("tracks", tracks, 1);
        Parameters.requireSamples("samples", samples, tracks);
        Parameters.requireSamples("channel bits", channelBits, 10 * LONGEST_RUN);
        Parameters.requirePositive("track pitch", trackPitch);
        Parameters.requirePositive("pit width", pitWidth);
        Parameters.requirePositive("pit depth", pitDepth);
        Parameters.requirePositive("wall width", wallWidth);
        if (pitWidth + wallWidth > trackPitch) {
            throw new IllegalArgumentException("pits of " + pitWidth + " m do not fit into tracks of " + trackPitch);
        }
    }

    /** 32 tracks of 1.6 um, 278 nm per bit (1.2 m/s at 4.3218 MHz), pits 500 nm wide and 110 nm deep; 50 nm apart. */
    static CompactDisc standard() {
        return new CompactDisc(32, 1024, 1.6e-6, 184, 500e-9, 110e-9, 150e-9, 3);
    }

    /** The patch: lands at height 0, pits below. */
    public HeightMap generate() {
        SeededNoise noise = new SeededNoise(seed);
        double[] heights = new double[samples * samples];
        for (int track = 0; track < tracks; track++) {
            double position = noise.uniform() * side();
            boolean pit = true;
            for (int run : runs(noise)) {
                double length = run * side() / channelBits;
                if (pit) {
                    sink(heights, (track + 0.5) * trackPitch, position, length);
                }
                pit = !pit;
                position += length;
            }
        }
        double pitch = side() / samples;
        return new HeightMap(samples, samples, pitch, pitch, heights);
    }

    private double side() {
        return tracks * trackPitch;
    }

    /** Pit, land, pit, land ... that fill the track exactly, so that it closes on itself. */
    private List<Integer> runs(SeededNoise noise) {
        List<Integer> runs = new ArrayList<>();
        int sum = 0;
        // About one try in ten ends on the last bit with a land.
        while (sum != channelBits || runs.size() % 2 != 0) {
            if (sum >= channelBits) {
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

    /** Sinks one pit: a bar with round ends, from {@code start} downwards, round the patch's edge where need be. */
    private void sink(double[] heights, double centre, double start, double length) {
        double pitch = side() / samples;
        double reach = (pitWidth + wallWidth) / 2;
        double middle = start + length / 2;
        double straight = Math.max(0, (length - pitWidth) / 2);
        int firstRow = (int) Math.floor((start - wallWidth) / pitch);
        int lastRow = (int) Math.ceil((start + length + wallWidth) / pitch);
        int firstColumn = (int) Math.floor((centre - reach) / pitch);
        int lastColumn = (int) Math.ceil((centre + reach) / pitch);
        for (int row = firstRow; row <= lastRow; row++) {
            double beyond = Math.max(0, Math.abs(row * pitch - middle) - straight);
            for (int column = firstColumn; column <= lastColumn; column++) {
                double outside = Math.hypot(column * pitch - centre, beyond) - pitWidth / 2;
                int index = Math.floorMod(row, samples) * samples + Math.floorMod(column, samples);
                heights[index] = Math.min(heights[index], -pitDepth * depthAt(outside));
            }
        }
    }

    /** Part of the full depth at a signed distance in metres from the line of half depth. */
    private double depthAt(double outside) {
        double z = Math.max(-1, Math.min(1, 2 * outside / wallWidth));
        return (1 - StrictMath.sin(StrictMath.PI / 2 * z)) / 2;
    }
}
