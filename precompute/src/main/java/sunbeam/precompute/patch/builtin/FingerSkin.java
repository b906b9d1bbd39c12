package sunbeam.precompute.patch.builtin;

import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Shed snake skin: overlapping rows of fingers on gently wavy ground, a model of what atomic force microscopy of
 * Elaphe and Xenopeltis skin shows. Where every number comes from stands in docs/guide.md.
 *
 * @param side width and height of the patch in metres
 * @param samples samples along each side
 * @param layout where the fingers are
 * @param shape what one of them looks like
 * @param ground waviness and grain
 * @param seed of everything random
 */
public record FingerSkin(double side, int samples, RowLayout layout, FingerShape shape, Ground ground, long seed) {
    /** Table places per sample: places are 16 nm apart, a quarter of a sample, and are interpolated linearly. */
    private static final int OVERSAMPLING = 4;

    /** Edges start this many of their standard deviations after the tips' line, so that both plates meet there. */
    private static final double EDGE_MARGIN = 2.5;

    /** The closest that rows may come, as a fraction of their mean distance. */
    private static final double CLOSEST = 0.35;

    public FingerSkin {
        Parameters.requirePositive("side", side);
        Parameters.requireSamples("samples", samples, 2 * ground.modes() + 1);
        Parameters.requirePositive("edge width", shape.edgeWidth());
        Parameters.requirePositive("finger length", shape.length());
        if (shape.length() > 1) {
            throw new IllegalArgumentException("fingers must end in their own row, got length " + shape.length());
        }
    }

    /** The patch, heights in metres about 0; the same for the same parameters. */
    public HeightMap generate() {
        SeededNoise noise = new SeededNoise(seed);
        int tableSize = OVERSAMPLING * samples;
        FingerRow[] rows = new RowPlacer(layout, shape, side, tableSize, noise).place();
        double[] heights = ground.heights(samples, side, noise);
        IntStream.range(0, samples).parallel().forEach(column -> addColumn(column, rows, heights));
        double pitch = side / samples;
        return new HeightMap(samples, samples, pitch, pitch, heights);
    }

    private void addColumn(int column, FingerRow[] rows, double[] heights) {
        double[] lines = lines(column * OVERSAMPLING, rows);
        double x = column * side / samples;
        int band = 0;
        Band plates = band(band, lines, rows);
        for (int row = 0; row < samples; row++) {
            // A sample above the first line lies below the last one, a period further down.
            double down = row * side / samples;
            while (down < lines[0]) {
                down += side;
            }
            int next = bandOf(down, lines, band);
            if (next != band) {
                band = next;
                plates = band(band, lines, rows);
            }
            heights[row * samples + column] += height(x, down - lines[band], plates);
        }
    }

    /** Two plates: that of the row whose line was passed last, and that of the row above, which it covers in part. */
    private record Band(FingerRow upper, FingerRow lower, double length, double lengthBelow) {}

    private static Band band(int band, double[] lines, FingerRow[] rows) {
        int upper = band % rows.length;
        int lower = Math.floorMod(band - 1, rows.length);
        return new Band(rows[upper], rows[lower], lines[upper + 1] - lines[upper], lines[lower + 1] - lines[lower]);
    }

    private static int bandOf(double down, double[] lines, int guess) {
        int band = down < lines[guess] ? 0 : guess;
        while (down >= lines[band + 1]) {
            band++;
        }
        return band;
    }

    /** The rows' lines at one place and again one period later, kept apart so that each row remains in its order. */
    private double[] lines(int place, FingerRow[] rows) {
        int count = rows.length;
        double least = CLOSEST * side / count;
        double[] lines = new double[2 * count + 1];
        lines[0] = rows[0].line(place);
        for (int i = 1; i < count; i++) {
            lines[i] = Math.max(rows[i].line(place), lines[i - 1] + least);
        }
        lines[count] = lines[0] + side;
        for (int i = count - 1; i > 0; i--) {
            lines[i] = Math.min(lines[i], lines[i + 1] - least);
        }
        for (int i = count + 1; i < lines.length; i++) {
            lines[i] = lines[i - count] + side;
        }
        return lines;
    }

    /** Height at a distance {@code down} below the line of the upper plate. */
    private double height(double x, double down, Band band) {
        double t = down / band.length();
        double place = place(x - layout.lean() * down);
        double cover = cover(band.upper(), place, down, band.length());
        double height = 0;
        if (cover > 0) {
            height += cover
                    * (shape.top(band.upper().phi(place), t) + band.upper().lift(place));
        }
        if (cover < 1) {
            double placeBelow = place(x - layout.lean() * (down + band.lengthBelow()));
            double notch = shape.notch(shape.length() * band.length() - down);
            double under =
                    shape.under(band.lower().phi(placeBelow), t) + band.lower().lift(placeBelow);
            height += (1 - cover) * (under - notch);
        }
        return height;
    }

    /** How much of the upper plate is there: 0 above its edge, 1 below, a smooth slope across it. */
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
        double periods = x / side;
        return (periods - Math.floor(periods)) * OVERSAMPLING * samples;
    }
}
