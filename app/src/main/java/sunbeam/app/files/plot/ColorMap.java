package sunbeam.app.files.plot;

/**
 * Color map from values between 0 and 1 to colors whose lightness grows with the value.
 *
 * @param points evenly spaced colors, 0xRRGGBB
 */
public record ColorMap(int... points) {
    /** Viridis (S. van der Walt and N. Smith, matplotlib, CC0), at nine evenly spaced points. */
    public static final ColorMap VIRIDIS =
            new ColorMap(0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725);

    /** Heights as microscopes show them. */
    public static final ColorMap GRAY = new ColorMap(0x000000, 0xFFFFFF);

    /** Returns a value's color as 0xRRGGBB, linear between the points; the ends' outside 0..1, white for NaN. */
    public int at(double value) {
        if (Double.isNaN(value)) {
            return 0xFFFFFF;
        }
        double position = Math.max(0, Math.min(1, value)) * (points.length - 1);
        int index = Math.min(points.length - 2, (int) position);
        double fraction = position - index;
        int color = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double before = (points[index] >> shift) & 0xFF;
            double after = (points[index + 1] >> shift) & 0xFF;
            color |= (int) Math.round(before + fraction * (after - before)) << shift;
        }
        return color;
    }
}
