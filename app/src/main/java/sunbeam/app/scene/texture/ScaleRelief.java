package sunbeam.app.scene.texture;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.scene.texture.BodyColors.SnakeHead;

/**
 * Relief of a snake's scales: convex plates in rows, neighbors offset by half a scale, each over the front of the next; on the belly a
 * shield per length of a scale. The texture repeats along the body and goes once around, v from belly to belly; below it lies the head's
 * relief. Red and green encode slopes along u and v, {@link #STEEPEST} times -1 to 1; blue pale pigment; alpha a factor of lightness, 0 to
 * {@link #LIGHTEST}.
 */
public final class ScaleRelief {
    /** End of the head in u; on it u is proportional to length. */
    public static final double BEGIN = 0.08;

    /** Along the repeating texture, each slightly different. */
    public static final int SCALES_ALONG = 8;

    /** In widths of a row; scales are two rows wide. */
    public static final double LENGTH = 2.1;

    /** Share of the girth; the belly takes the rest. */
    public static final double DORSAL = 0.76;

    /** Slope that red or green 1 encodes. */
    public static final double STEEPEST = 0.4;

    /** Lightness that alpha 1 encodes. */
    public static final double LIGHTEST = 1.25;

    /** Head's share of the texture's height, from v = 0 on. */
    public static final double HEAD_SHARE = 0.2;

    private static final int TEXELS = 1024;
    private static final int HEAD_ROWS = 256;
    // In widths of a row: dome, rise over a scale's length towards the rear, drop at its rim.
    private static final double DOME = 0.085;
    private static final double TILT = 0.22;
    private static final double RIM = 0.0175;
    // Half width, of half a scale's width.
    private static final double KEEL = 0.5;
    // Rows with pale rims above the lowest row, which is pale.
    private static final int PALE_RIMS = 2;
    // Random variation of slopes, and of lightness relative to 1.
    private static final double SLOPE_VARIATION = 0.02;
    private static final double LIGHTNESS_VARIATION = 0.09;
    // From the middle to rear and covered front in lengths of a scale, and to the sides in widths of a row.
    private static final double REAR_LENGTH = 0.6;
    private static final double FRONT_LENGTH = 0.9;
    private static final double HALF_WIDTH = 1.04;
    // {@link Plate} edge up to which a plate darkens the one below.
    private static final double SHADED_EDGE = 1.6;
    // Step of derivatives, in lengths of a scale and widths of a row.
    private static final double STEP = 1e-3;
    private static final int FIRST_ROW = 64;

    private final Scales scales;
    // Row 0 is the middle of the back.
    private final int outermostRow;

    private ScaleRelief(Scales scales) {
        this.scales = scales;
        this.outermostRow = scales.rows() / 2;
    }

    public static BodyTexture of(Scales scales, BlobCache cache) {
        if (scales == Scales.NONE) {
            return BodyTexture.ofTexel(128, 128, 0, code(1 / LIGHTEST));
        }
        ScaleRelief relief = new ScaleRelief(scales);
        int rows = TEXELS + HEAD_ROWS;
        String name = "relief of head and " + scales.rows() + " rows of scales";
        return new BodyTexture(TEXELS, rows, cache.get(name, 4 * TEXELS * rows, relief::texels));
    }

    private byte[] texels() {
        byte[] rgba = new byte[4 * TEXELS * (TEXELS + HEAD_ROWS)];
        CornerMeans.paint(
                TEXELS,
                TEXELS,
                (column, row) -> point(
                        (double) SCALES_ALONG * column / TEXELS,
                        (1 - 2.0 * row / TEXELS) * scales.rows() / (2 * DORSAL)),
                (column, row, mean) -> {
                    int at = 4 * (row * TEXELS + column);
                    rgba[at] = slope(mean[0], noise(2 * at));
                    rgba[at + 1] = slope(mean[1], noise(2 * at + 1));
                    rgba[at + 2] = code(mean[3]);
                    rgba[at + 3] = code(mean[2] / LIGHTEST);
                });
        IntStream.range(0, HEAD_ROWS).parallel().forEach(row -> {
            for (int column = 0; column < TEXELS; column++) {
                headTexel(column, row, rgba, 4 * ((TEXELS + row) * TEXELS + column));
            }
        });
        return rgba;
    }

    private static void headTexel(int column, int row, byte[] rgba, int at) {
        double along = (column + 0.5) / TEXELS;
        double around = 1 - 2 * (row + 0.5) / HEAD_ROWS;
        double ahead = SnakeHead.height(along + STEP, around) - SnakeHead.height(along - STEP, around);
        double beside = SnakeHead.height(along, around + STEP) - SnakeHead.height(along, around - STEP);
        rgba[at] = slope(ahead / (2 * STEP), noise(2 * at));
        rgba[at + 1] = slope(beside / (2 * STEP * SnakeHead.HALF_GIRTH), noise(2 * at + 1));
        rgba[at + 3] = code(1 / LIGHTEST);
    }

    /**
     * Point on a plate.
     *
     * @param number seed of the plate's random variation
     * @param along from its middle towards the tail, in lengths of a scale
     * @param beside from its middle to the side, 1 at its edge
     * @param edge 0 in its middle, 1 on its outline, larger outside
     */
    private record Plate(int number, double along, double beside, double edge, boolean isShield) {}

    /**
     * Returns the middle of the scale that is seen at a place, in the same coordinates; the place itself on the belly.
     *
     * @param along texture coordinate u
     * @param around angle from the middle of the back over pi
     */
    static double[] middleOfScale(Scales scales, double along, double around) {
        double rowsPerTurn = scales.rows() / (2 * DORSAL);
        double x = along * scales.perUnit();
        double y = around * rowsPerTurn;
        Plate top = new ScaleRelief(scales).plates(x, y).get(0);
        return top.isShield
                ? new double[] {along, around}
                : new double[] {(x - top.along) / scales.perUnit(), (y - HALF_WIDTH * top.beside) / rowsPerTurn};
    }

    /**
     * Returns slopes along u and v, lightness and pale pigment.
     *
     * @param x along the body, in lengths of a scale
     * @param y around the body from the middle of the back, in widths of a row
     */
    private double[] point(double x, double y) {
        List<Plate> plates = plates(x, y);
        Plate top = plates.get(0);
        double covered = 0;
        for (Plate plate : plates.subList(1, plates.size())) {
            if (top.isShield || plate.along > top.along) {
                double near = (SHADED_EDGE - plate.edge) / (SHADED_EDGE - 1);
                covered = Math.max(covered, near * near * near);
            }
        }
        double unevenAlong = SLOPE_VARIATION * noise(3 * top.number);
        double unevenAround = SLOPE_VARIATION * noise(3 * top.number + 1);
        double slopeAlong =
                (height(x + STEP, y, top, STEP, 0) - height(x - STEP, y, top, -STEP, 0)) / (2 * STEP) / LENGTH;
        double slopeAround = (height(x, y + STEP, top, 0, STEP) - height(x, y - STEP, top, 0, -STEP)) / (2 * STEP);
        double rim = top.edge * top.edge * top.edge;
        double lightness = (1 + LIGHTNESS_VARIATION * noise(3 * top.number + 2))
                * (1 - 0.72 * covered)
                * (1.06 - 0.42 * rim * rim);
        return new double[] {slopeAlong + unevenAlong, slopeAround + unevenAround, lightness, pale(top)};
    }

    /** Returns the plate that is seen at a point, then those that end near it. */
    private List<Plate> plates(double x, double y) {
        Plate top = null;
        List<Plate> all = new ArrayList<>();
        for (int row = floor(y - 1.5); row <= y + 1.5; row++) {
            double offset = 0.5 * (row & 1);
            int first = -floor(-(x - offset - 1));
            for (int scale = first; Math.abs(row) <= outermostRow && scale <= x - offset + FRONT_LENGTH; scale++) {
                Plate plate = scale(row, scale, x - offset - scale, (y - row) / HALF_WIDTH);
                if (plate.edge >= 1 && plate.edge < SHADED_EDGE && plate.along >= 0) {
                    all.add(plate);
                } else if (plate.edge < 1 && (top == null || plate.along > top.along)) {
                    top = plate;
                }
            }
        }
        all.add(0, top == null ? shield(x, y) : top);
        return all;
    }

    private static int floor(double value) {
        int whole = (int) value;
        return whole > value ? whole - 1 : whole;
    }

    private double pale(Plate plate) {
        int aboveLowest = outermostRow - Math.abs(plate.number / SCALES_ALONG - FIRST_ROW);
        if (scales != Scales.SMOOTH || plate.isShield || aboveLowest > PALE_RIMS) {
            return 0;
        }
        return aboveLowest == 0 ? 1 : 0.8 * BodyColors.step(0.5, 0.95, plate.edge);
    }

    private Plate scale(int row, int scale, double along, double beside) {
        double ahead = along / (along > 0 ? REAR_LENGTH : FRONT_LENGTH);
        double edge = ahead * ahead + beside * beside;
        return new Plate(
                Math.floorMod(scale, SCALES_ALONG) + SCALES_ALONG * (row + FIRST_ROW), along, beside, edge, false);
    }

    private Plate shield(double x, double y) {
        double halfGirth = scales.rows() / (2 * DORSAL);
        double beside = (halfGirth - Math.abs(y)) / (halfGirth - outermostRow);
        double bent = x + 0.25 * beside * beside;
        int number = floor(bent);
        double along = bent - number - 0.5;
        return new Plate(Math.floorMod(number, SCALES_ALONG), along, beside, shieldEdge(along), true);
    }

    /** Height of a plate, continued beyond its outline, in widths of a row, (dx, dy) from the plate's point. */
    private double height(double x, double y, Plate plate, double dx, double dy) {
        Plate there = plate.isShield
                ? shieldBeside(x, y, plate)
                : scale(0, 0, plate.along + dx, plate.beside + dy / HALF_WIDTH);
        double rounding = Math.max(0, (there.edge - 0.65) / 0.35);
        double dome = plate.isShield ? 0 : DOME * (1 - there.beside * there.beside);
        double besideKeel = there.beside * there.beside / (KEEL * KEEL);
        double keel = plate.isShield ? 0 : scales.keel() / ((1 + besideKeel) * (1 + besideKeel));
        return TILT * there.along + dome + keel - RIM * rounding * rounding;
    }

    private Plate shieldBeside(double x, double y, Plate plate) {
        Plate there = shield(x, y);
        // Beyond its end lies the next shield; this continues the plate's own.
        double along = there.along + Math.rint(plate.along - there.along);
        return new Plate(plate.number, along, there.beside, shieldEdge(along), true);
    }

    private static double shieldEdge(double along) {
        double square = 4 * along * along;
        return along > 0 ? square * square : 0;
    }

    private static double noise(int number) {
        return BodyColors.SkinNoise.hash((number + 1) * 0x9e3779b9);
    }

    /** Random dither hides the steps of bytes. */
    private static byte slope(double slope, double noise) {
        double steps = 127 * Math.max(-0.99, Math.min(0.99, slope / STEEPEST));
        return (byte) (128 + Math.round(steps + 0.5 * noise));
    }

    private static byte code(double share) {
        return (byte) Math.round(255 * Math.max(0, Math.min(1, share)));
    }
}
