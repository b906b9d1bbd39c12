package sunbeam.app.scene.texture;

import java.util.stream.IntStream;
import sunbeam.app.files.cache.BlobCache;

/**
 * The relief of a snake's scales: convex plates in rows that are offset by half a scale, each of which covers the front of the next; below
 * them one shield a scale across the belly. A texture that repeats along the body and goes once around it, v from belly to belly: red and
 * green are slopes along u and v, {@link #STEEPEST} times -1 to 1; alpha is a factor of the skin's lightness, 0 to {@link #LIGHTEST}.
 */
public final class ScaleRelief {
    /** Texture coordinate u where the head ends and scales begin; on the head it is proportional to length. */
    public static final double BEGIN = 0.08;

    /** Scales along the repeating texture, each slightly different. */
    public static final int SCALES_ALONG = 8;

    /** Length of a scale in widths of a row: scales are two rows wide. */
    public static final double LENGTH = 2.1;

    /** Share of the girth covered by rows of scales; the belly takes the rest. */
    public static final double DORSAL = 0.76;

    /** Largest slope that red and green encode. */
    public static final double STEEPEST = 0.4;

    /** Lightness that alpha 1 encodes. */
    public static final double LIGHTEST = 1.25;

    private static final int SIDE = 1024;
    // Heights in widths of a row: of the dome, of a scale's rear over its front, of the drop at its rim.
    private static final double DOME = 0.085;
    private static final double TILT = 0.22;
    private static final double RIM = 0.035;
    // Half width of the keel, as a share of half a scale's width.
    private static final double KEEL = 0.3;
    // Random variation of the scales' slopes and lightness.
    private static final double UNEVEN = 0.02;
    private static final double TINT = 0.09;
    // Ends of a scale behind and in front of its middle, in lengths, and beside it, in rows; its front is covered.
    private static final double REAR = 0.6;
    private static final double FRONT = 0.9;
    private static final double BESIDE = 1.04;
    private static final double STEP = 1e-3;
    private static final int POINTS = 2;

    private final Scales scales;
    private final int outermost;

    private ScaleRelief(Scales scales) {
        this.scales = scales;
        this.outermost = scales.rows() / 2;
    }

    /**
     * Returns the relief of scales; a single flat texel for none.
     *
     * @param kept cache of reliefs
     */
    public static BodyTexture of(Scales scales, BlobCache kept) {
        if (scales == Scales.NONE) {
            return new BodyTexture(1, 1, new byte[] {(byte) 128, (byte) 128, 0, code(1 / LIGHTEST)});
        }
        ScaleRelief relief = new ScaleRelief(scales);
        return new BodyTexture(
                SIDE,
                SIDE,
                kept.get("relief of " + scales.rows() + " rows of scales", 4 * SIDE * SIDE, relief::texels));
    }

    private byte[] texels() {
        byte[] rgba = new byte[4 * SIDE * SIDE];
        IntStream.range(0, SIDE).parallel().forEach(row -> {
            for (int column = 0; column < SIDE; column++) {
                texel(column, row, rgba, 4 * (row * SIDE + column));
            }
        });
        return rgba;
    }

    /**
     * A plate and a point's position on it.
     *
     * @param number of the plate
     * @param along from its middle towards the tail, in lengths
     * @param beside from its middle, 1 at its side
     * @param edge 0 in its middle, 1 on its outline
     * @param isShield whether it is one of the belly's
     */
    private record Plate(int number, double along, double beside, double edge, boolean isShield) {}

    /** Computes a texel as the mean of several points, so that rims are smooth. */
    private void texel(int column, int row, byte[] rgba, int at) {
        double[] sum = new double[3];
        for (int i = 0; i < POINTS; i++) {
            double around = 1 - 2 * (row + (i + 0.5) / POINTS) / SIDE;
            for (int j = 0; j < POINTS; j++) {
                double along = SCALES_ALONG * (column + (j + 0.5) / POINTS) / SIDE;
                add(along, around * scales.rows() / (2 * DORSAL), sum);
            }
        }
        double share = 1.0 / (POINTS * POINTS);
        rgba[at] = slope(share * sum[0], noise(2 * at));
        rgba[at + 1] = slope(share * sum[1], noise(2 * at + 1));
        rgba[at + 3] = code(share * sum[2] / LIGHTEST);
    }

    private void add(double x, double y, double[] sum) {
        Plate top = null;
        double covered = 0;
        for (int row = (int) Math.floor(y - BESIDE); row <= y + BESIDE; row++) {
            double offset = 0.5 * (row & 1);
            if (Math.abs(row) > outermost) {
                continue;
            }
            for (int scale = (int) Math.ceil(x - offset - 1); scale <= x - offset + FRONT; scale++) {
                Plate plate = scale(row, scale, x - offset - scale, (y - row) / BESIDE);
                if (plate.edge < 1 && (top == null || plate.along > top.along)) {
                    top = plate;
                }
            }
        }
        if (top == null) {
            top = shield(x, y);
        }
        for (int row = (int) Math.floor(y - 1.5); row <= y + 1.5; row++) {
            double offset = 0.5 * (row & 1);
            for (int scale = (int) Math.ceil(x - offset - 1);
                    Math.abs(row) <= outermost && scale <= x - offset;
                    scale++) {
                Plate plate = scale(row, scale, x - offset - scale, (y - row) / BESIDE);
                if (plate.edge >= 1 && (top.isShield || plate.along > top.along)) {
                    double near = Math.max(0, 1.6 - plate.edge) / 0.6;
                    covered = Math.max(covered, near * near * near);
                }
            }
        }
        double unevenAlong = UNEVEN * noise(3 * top.number);
        double unevenAround = UNEVEN * noise(3 * top.number + 1);
        double slopeAlong =
                (height(x + STEP, y, top, STEP, 0) - height(x - STEP, y, top, -STEP, 0)) / (2 * STEP) / LENGTH;
        double slopeAround = (height(x, y + STEP, top, 0, STEP) - height(x, y - STEP, top, 0, -STEP)) / (2 * STEP);
        double rim = top.edge * top.edge * top.edge;
        double light = (1 + TINT * noise(3 * top.number + 2)) * (1 - 0.72 * covered) * (1.06 - 0.42 * rim * rim);
        sum[0] += slopeAlong + unevenAlong;
        sum[1] += slopeAround + unevenAround;
        sum[2] += light;
    }

    private Plate scale(int row, int scale, double along, double beside) {
        double ahead = along / (along > 0 ? REAR : FRONT);
        double edge = ahead * ahead + beside * beside;
        return new Plate(Math.floorMod(scale, SCALES_ALONG) + SCALES_ALONG * (row + 64), along, beside, edge, false);
    }

    /** Returns the belly's shield at a point; its rear edge bends towards the tail in the middle. */
    private Plate shield(double x, double y) {
        double halfGirth = scales.rows() / (2 * DORSAL);
        double beside = (halfGirth - Math.abs(y)) / (halfGirth - outermost);
        double bent = x + 0.25 * beside * beside;
        int number = (int) Math.floor(bent);
        double along = bent - number - 0.5;
        return new Plate(Math.floorMod(number, SCALES_ALONG), along, beside, shieldEdge(along), true);
    }

    /** Height of a plate's surface at an offset from a point, continued beyond its outline. */
    private double height(double x, double y, Plate plate, double dx, double dy) {
        Plate there =
                plate.isShield ? shieldBeside(x, y, plate) : scale(0, 0, plate.along + dx, plate.beside + dy / BESIDE);
        double rounding = Math.max(0, (there.edge - 0.65) / 0.35);
        double dome = plate.isShield ? 0 : DOME * (1 - there.beside * there.beside);
        double besideKeel = there.beside * there.beside / (KEEL * KEEL);
        double keel = plate.isShield ? 0 : scales.keel() / ((1 + besideKeel) * (1 + besideKeel));
        return TILT * there.along + dome + keel - RIM * rounding * rounding;
    }

    private Plate shieldBeside(double x, double y, Plate plate) {
        Plate there = shield(x, y);
        // Stays on the same shield, even beyond its end.
        double along = there.along + Math.rint(plate.along - there.along);
        return new Plate(plate.number, along, there.beside, shieldEdge(along), true);
    }

    private static double shieldEdge(double along) {
        double square = 4 * along * along;
        return along > 0 ? square * square : 0;
    }

    private static double noise(int number) {
        return SkinNoise.hashed((number + 1) * 0x9e3779b9);
    }

    /** Encodes a slope with random rounding, which hides steps. */
    private static byte slope(double slope, double noise) {
        double steps = 127 * Math.max(-0.99, Math.min(0.99, slope / STEEPEST));
        return (byte) (128 + Math.round(steps + 0.5 * noise));
    }

    private static byte code(double share) {
        return (byte) Math.round(255 * Math.max(0, Math.min(1, share)));
    }
}
