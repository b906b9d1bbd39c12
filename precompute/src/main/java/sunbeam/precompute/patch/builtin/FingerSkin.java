package sunbeam.precompute.patch.builtin;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.builtin.RowLayout.FingerRow;

/**
 * Model of shed snake skin: overlapping rows of fingers on gently wavy ground, as in atomic force microscopy.
 *
 * @param wavinessExponent the ground's power spectral density falls as frequency to minus this power
 * @param grain fine roughness, root mean square in meters
 */
record FingerSkin(RowLayout layout, FingerShape shape, double wavinessExponent, double grain, long seed) {
    // In the order of RowLayout: rows (3.1 and 1.55 um apart), fingers (1.03 and 0.55 um apart), their spreads, rows
    // over which columns continue, count spread, wander, its modes along x and y, tip spread, height spread, lean.
    private static final RowLayout ELAPHE_ROWS = new RowLayout(21, 63, 0.09, 0.16, 4, 0, 0.6e-6, 9, 6, 0.4e-6, 7e-9, 0);
    private static final RowLayout XENOPELTIS_ROWS =
            new RowLayout(42, 118, 0.02, 0.15, 0, 2, 0.9e-6, 14, 4, 0.1e-6, 11e-9, 0.07);
    // In the order of FingerShape: length, exponents of tip and base, crest, fall, bulge, dome, fade, floor, floor
    // fall, depth and length of notches, edge width.
    private static final FingerShape ELAPHE_FINGERS =
            new FingerShape(0.97, 2.4, 2.6, 38e-9, 0, 6e-9, 48e-9, 0.25, -31e-9, 5e-9, 55e-9, 220e-9, 35e-9);
    private static final FingerShape XENOPELTIS_FINGERS =
            new FingerShape(0.72, 3.2, 1.7, 78e-9, 125e-9, 0, 30e-9, 0.2, -42e-9, 0, 70e-9, 200e-9, 35e-9);

    /** Elaphe guttata: long pointed fingers in columns that run on over many rows, so colors lie along x only. */
    static final FingerSkin ELAPHE = new FingerSkin(ELAPHE_ROWS, ELAPHE_FINGERS, 3.6, 6e-9, 1);

    /** Xenopeltis unicolor: blunt short fingers in independent, meandering rows, so colors spread about y. */
    static final FingerSkin XENOPELTIS = new FingerSkin(XENOPELTIS_ROWS, XENOPELTIS_FINGERS, 3.2, 7e-9, 2);

    private static final double SIDE = 65e-6;
    // 63.5 nm apart, finer than the 95 nm that 380 nm light needs.
    private static final int SAMPLES = 1024;
    // Waviness of the ground, root mean square in meters.
    private static final double WAVINESS = 34e-9;
    // Periods along the side.
    private static final int WAVINESS_MODES = 24;
    // Standard deviation of the grain's smoothing, meters.
    private static final double GRAIN_LENGTH = 60e-9;
    // Table entries per sample, 16 nm apart.
    private static final int OVERSAMPLING = 4;
    // Half width of an edge's transition, in its standard deviations.
    private static final double EDGE_MARGIN = 2.5;
    // Distance between rows, relative to its mean.
    private static final double CLOSEST = 0.35;

    public HeightMap generate() {
        SeededNoise noise = new SeededNoise(seed);
        FingerRow[] rows = layout.place(shape, SIDE, OVERSAMPLING * SAMPLES, noise);
        double[] heights = noise.powerLaw(SAMPLES, SAMPLES, WAVINESS, wavinessExponent, WAVINESS_MODES, WAVINESS_MODES);
        double[] grains = noise.grain(SAMPLES, GRAIN_LENGTH * SAMPLES / SIDE);
        for (int i = 0; i < heights.length; i++) {
            heights[i] += grain * grains[i];
        }
        IntStream.range(0, SAMPLES).parallel().forEach(column -> addColumn(column, rows, heights));
        return new HeightMap(SAMPLES, SAMPLES, SIDE / SAMPLES, SIDE / SAMPLES, heights);
    }

    private void addColumn(int column, FingerRow[] rows, double[] heights) {
        double[] lines = lines(column * OVERSAMPLING, rows);
        double x = column * SIDE / SAMPLES;
        for (int row = 0; row < SAMPLES; row++) {
            // Above the first line lies the last row of the previous period.
            double down = row * SIDE / SAMPLES;
            while (down < lines[0]) {
                down += SIDE;
            }
            int found = Arrays.binarySearch(lines, down);
            int strip = found < 0 ? -found - 2 : found;
            heights[row * SAMPLES + column] += height(x, down - lines[strip], strip(strip, lines, rows));
        }
    }

    /**
     * Strip between the lines of two neighboring rows, where the plate of {@code upper}, whose tips lie on its upper line, covers that of {@code
     * lower}, whose tips lie one row higher; and the lengths of this strip and of the one above it, meters.
     */
    private record Strip(FingerRow upper, FingerRow lower, double length, double lengthBelow) {}

    private static Strip strip(int strip, double[] lines, FingerRow[] rows) {
        int upper = strip % rows.length;
        int lower = Math.floorMod(strip - 1, rows.length);
        return new Strip(rows[upper], rows[lower], lines[upper + 1] - lines[upper], lines[lower + 1] - lines[lower]);
    }

    /** Returns distances of the rows' lines from the top, over two periods, in meters; close lines are moved apart. */
    private double[] lines(int place, FingerRow[] rows) {
        int count = rows.length;
        double least = CLOSEST * SIDE / count;
        double[] lines = new double[2 * count + 1];
        lines[0] = rows[0].line()[place];
        for (int i = 1; i < count; i++) {
            lines[i] = Math.max(rows[i].line()[place], lines[i - 1] + least);
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

    private double height(double x, double down, Strip strip) {
        double t = down / strip.length();
        double place = place(x - layout.lean() * down);
        double cover = cover(strip.upper(), place, down, strip.length());
        double height = 0;
        if (cover > 0) {
            height += cover
                    * (shape.top(FingerRow.at(strip.upper().phi(), place), t)
                            + FingerRow.at(strip.upper().lift(), place));
        }
        if (cover < 1) {
            double placeBelow = place(x - layout.lean() * (down + strip.lengthBelow()));
            double under = shape.under(FingerRow.at(strip.lower().phi(), placeBelow), t)
                    + FingerRow.at(strip.lower().lift(), placeBelow);
            height += (1 - cover) * (under - shape.notch(shape.length() * strip.length() - down));
        }
        return height;
    }

    /** 0 above the upper plate's edge, 1 below it. */
    private double cover(FingerRow row, double place, double down, double length) {
        double margin = EDGE_MARGIN * shape.edgeWidth();
        double finger = shape.length() * length - 2 * margin;
        double steepness = Math.hypot(1, finger * FingerRow.at(row.edgeSlope(), place));
        double distance = (down - margin - finger * FingerRow.at(row.edge(), place)) / steepness;
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

    /**
     * Shape of the plate of a row of fingers, which lies on the plate above and dives under the one below. Heights are in meters above the
     * mean surface.
     *
     * <p>Let t be 0 at the tips and 1 where the next row begins, phi 0 on a finger's ridge and 1 midway to its neighbor. The edge is at t =
     * length (1 - (1 - phi^tipExponent)^baseExponent).
     *
     * @param length from the tips to the notches' bottom, as a fraction of the rows' distance
     * @param tipExponent exponent; small: pointed tips; large: blunt ones
     * @param baseExponent exponent; large: notches that close slowly, like a narrow V
     * @param crest height of the ridge at the tip
     * @param fall drop of the ridge until the next row begins
     * @param bulge arch of the ridge between its ends
     * @param dome depth of a finger's flank below its ridge
     * @param fade decay length under the next row, as a fraction of the rows' distance
     * @param floor height of the ground between the fingers at the next row
     * @param floorFall further drop of this ground until the end of the plate
     * @param notchDepth additional depth of the ground at the bottom of the notches
     * @param notchLength decay length of that depth, meters
     * @param edgeWidth standard deviation in meters of the edges' rounding (the probe's tip)
     */
    record FingerShape(
            double length,
            double tipExponent,
            double baseExponent,
            double crest,
            double fall,
            double bulge,
            double dome,
            double fade,
            double floor,
            double floorFall,
            double notchDepth,
            double notchLength,
            double edgeWidth) {

        double top(double phi, double t) {
            double inFinger = Math.min(1, phi / halfWidth(t / length));
            return crest - fall * t + 4 * bulge * t * (1 - t) - dome * inFinger * inFinger;
        }

        /** Returns the height under the next row's fingers, at their t: from {@code top(phi, 1)} to the floor. */
        double under(double phi, double t) {
            return (top(phi, 1) - floor) * Math.exp(-t / fade) + floor - floorFall * t;
        }

        double notch(double distance) {
            return notchDepth * Math.exp(-Math.max(0, distance) / notchLength);
        }

        double edge(double phi) {
            return 1 - Math.pow(1 - Math.pow(phi, tipExponent), baseExponent);
        }

        /** Inverse of {@link #edge}: half width of a finger, as phi. */
        private double halfWidth(double position) {
            return position >= 1
                    ? 1
                    : Math.max(0.1, Math.pow(1 - Math.pow(1 - position, 1 / baseExponent), 1 / tipExponent));
        }
    }
}
