package sunbeam.precompute.patch.builtin;

import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Model of shed snake skin: overlapping rows of fingers on gently wavy ground, as in atomic force microscopy.
 *
 * @param wavinessExponent the ground's power spectral density falls as frequency to minus this power
 * @param grain fine roughness, root mean square in meters
 */
record FingerSkin(RowLayout layout, FingerShape shape, double wavinessExponent, double grain, long seed) {
    /** Elaphe guttata: long pointed fingers in columns that run on over many rows, so colors lie along x only. */
    static final FingerSkin ELAPHE = new FingerSkin(
            new RowLayout(
                    21, // rows: 3.1 um apart
                    63, // fingers: 1.03 um apart
                    0.09, // row spread
                    0.16, // finger spread
                    4, // rows over which columns continue
                    0, // count spread: none, columns continue
                    0.6e-6, // wander
                    9, // wander modes along x
                    6, // wander modes along y
                    0.4e-6, // tip spread
                    7e-9, // height spread
                    0), // lean
            new FingerShape(
                    0.97, // length
                    2.4, // tip exponent
                    2.6, // base exponent
                    38e-9, // crest
                    0, // fall
                    6e-9, // bulge
                    48e-9, // dome
                    0.25, // fade
                    -31e-9, // floor
                    5e-9, // floor fall
                    55e-9, // notch depth
                    220e-9, // notch length
                    35e-9), // edge width
            3.6,
            6e-9,
            1);

    /** Xenopeltis unicolor: blunt short fingers in independent, meandering rows, so colors spread about y. */
    static final FingerSkin XENOPELTIS = new FingerSkin(
            new RowLayout(
                    42, // rows: 1.55 um apart
                    118, // fingers: 0.55 um apart
                    0.02, // row spread
                    0.15, // finger spread
                    0, // rows are independent
                    2, // count spread
                    0.9e-6, // wander
                    14, // wander modes along x
                    4, // wander modes along y
                    0.1e-6, // tip spread
                    11e-9, // height spread
                    0.07), // lean: 4 degrees
            new FingerShape(
                    0.72, // length
                    3.2, // tip exponent
                    1.7, // base exponent
                    78e-9, // crest
                    125e-9, // fall
                    0, // bulge
                    30e-9, // dome
                    0.2, // fade
                    -42e-9, // floor
                    0, // floor fall
                    70e-9, // notch depth
                    200e-9, // notch length
                    35e-9), // edge width
            3.2,
            7e-9,
            2);

    private static final double SIDE = 65e-6;
    /** 63.5 nm apart, finer than the 95 nm that 380 nm light needs. */
    private static final int SAMPLES = 1024;

    /** Waviness of the ground, root mean square in meters. */
    private static final double WAVINESS = 34e-9;
    /** Periods along the side. */
    private static final int WAVINESS_MODES = 24;
    /** Standard deviation of the Gaussian that smooths the grain, meters. */
    private static final double GRAIN_LENGTH = 60e-9;

    /** Table entries per sample, 16 nm apart. */
    private static final int OVERSAMPLING = 4;

    /** Half the width of an edge's transition, in its standard deviations. */
    private static final double EDGE_MARGIN = 2.5;

    /** Least distance between rows, relative to the mean distance. */
    private static final double CLOSEST = 0.35;

    public HeightMap generate() {
        SeededNoise noise = new SeededNoise(seed);
        FingerRow[] rows = layout.place(shape, SIDE, OVERSAMPLING * SAMPLES, noise);
        double[] heights = PeriodicField.powerLaw(
                SAMPLES, SAMPLES, WAVINESS, wavinessExponent, WAVINESS_MODES, WAVINESS_MODES, noise);
        double[] grains = PeriodicField.grain(SAMPLES, GRAIN_LENGTH * SAMPLES / SIDE, noise);
        for (int i = 0; i < heights.length; i++) {
            heights[i] += grain * grains[i];
        }
        IntStream.range(0, SAMPLES).parallel().forEach(column -> addColumn(column, rows, heights));
        return new HeightMap(SAMPLES, SAMPLES, SIDE / SAMPLES, SIDE / SAMPLES, heights);
    }

    private void addColumn(int column, FingerRow[] rows, double[] heights) {
        double[] lines = lines(column * OVERSAMPLING, rows);
        double x = column * SIDE / SAMPLES;
        int strip = 0;
        Strip plates = strip(strip, lines, rows);
        for (int row = 0; row < SAMPLES; row++) {
            // A sample above the first line is below the last line of the previous period.
            double down = row * SIDE / SAMPLES;
            while (down < lines[0]) {
                down += SIDE;
            }
            int next = stripOf(down, lines, strip);
            if (next != strip) {
                strip = next;
                plates = strip(strip, lines, rows);
            }
            heights[row * SAMPLES + column] += height(x, down - lines[strip], plates);
        }
    }

    /**
     * Strip between the lines of two neighboring rows, where one plate partly covers another.
     *
     * @param upper covering row, whose tips lie on the strip's upper line
     * @param lower covered row, whose tips lie one row higher
     * @param length distance between the strip's lines, meters
     * @param lengthBelow the same distance of the strip above, where the covered row begins, meters
     */
    private record Strip(FingerRow upper, FingerRow lower, double length, double lengthBelow) {}

    private static Strip strip(int strip, double[] lines, FingerRow[] rows) {
        int upper = strip % rows.length;
        int lower = Math.floorMod(strip - 1, rows.length);
        return new Strip(rows[upper], rows[lower], lines[upper + 1] - lines[upper], lines[lower + 1] - lines[lower]);
    }

    private static int stripOf(double down, double[] lines, int guess) {
        int strip = down < lines[guess] ? 0 : guess;
        while (down >= lines[strip + 1]) {
            strip++;
        }
        return strip;
    }

    /** Returns distances of the rows' lines from the top at one table index, over two periods, in meters; close lines are moved apart. */
    private double[] lines(int place, FingerRow[] rows) {
        int count = rows.length;
        double least = CLOSEST * SIDE / count;
        double[] lines = new double[2 * count + 1];
        lines[0] = rows[0].line(place);
        for (int i = 1; i < count; i++) {
            lines[i] = Math.max(rows[i].line(place), lines[i - 1] + least);
        }
        lines[count] = lines[0] + SIDE;
        for (int i = count - 1; i > 0; i--) {
            lines[i] = Math.min(lines[i], lines[i + 1] - least);
        }
        for (int i = count + 1; i < lines.length; i++) {
            lines[i] = lines[i - count] + SIDE;
        }
        return lines;
    }

    /** Returns the height at a distance {@code down} below the strip's upper line; both in meters. */
    private double height(double x, double down, Strip strip) {
        double t = down / strip.length();
        double place = place(x - layout.lean() * down);
        double cover = cover(strip.upper(), place, down, strip.length());
        double height = 0;
        if (cover > 0) {
            height += cover
                    * (shape.top(strip.upper().phi(place), t) + strip.upper().lift(place));
        }
        if (cover < 1) {
            double placeBelow = place(x - layout.lean() * (down + strip.lengthBelow()));
            double notch = shape.notch(shape.length() * strip.length() - down);
            double under = shape.under(strip.lower().phi(placeBelow), t)
                    + strip.lower().lift(placeBelow);
            height += (1 - cover) * (under - notch);
        }
        return height;
    }

    /** 0 above the upper plate's edge, 1 below it. */
    private double cover(FingerRow row, double place, double down, double length) {
        double margin = EDGE_MARGIN * shape.edgeWidth();
        double finger = shape.length() * length - 2 * margin;
        double steepness = Math.hypot(1, finger * row.edgeSlope(place));
        double distance = (down - margin - finger * row.edge(place)) / steepness;
        double z = distance / margin;
        if (Math.abs(z) >= 1) {
            return z > 0 ? 1 : 0;
        }
        return (1 + Math.sin(Math.PI / 2 * z)) / 2;
    }

    private double place(double x) {
        double periods = x / SIDE;
        return (periods - Math.floor(periods)) * OVERSAMPLING * SAMPLES;
    }
}
