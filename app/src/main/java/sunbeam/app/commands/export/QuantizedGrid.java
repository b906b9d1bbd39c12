package sunbeam.app.commands.export;

import java.util.zip.Deflater;
import sunbeam.app.files.output.Deflated;

/**
 * A table in few bytes: logarithms in equal steps of Y, X by Y and Z by Y, coded as differences to what the neighbors and the
 * slice before predict, as bytes of low and high order apart, deflated. page.html unpacks it.
 *
 * @param grid whose numbers are the rounded ones
 * @param packed zlib's format
 * @param most largest number of steps of any color
 */
record QuantizedGrid(ColorGrid grid, byte[] packed, int most) {
    /** Added to each color before its logarithm is taken: what is darker is of no account. */
    static final double FLOOR = 1e-10;

    private static final int CHANNELS = ColorGrid.CHANNELS;

    /** @param octaves step of the logarithm to base 2 */
    static QuantizedGrid of(ColorGrid grid, double octaves) {
        GridShape shape = grid.shape();
        int texels = shape.texels();
        int all = Math.toIntExact(shape.allTexels());
        byte[] codes = new byte[2 * CHANNELS * all];
        ColorGrid rounded = ColorGrid.empty(grid.level(), shape);
        int[][] before = new int[CHANNELS][texels];
        int[] steps = new int[CHANNELS];
        int most = 0;
        for (int slice = 0; slice < shape.depth().count(); slice++) {
            int[][] now = new int[CHANNELS][texels];
            for (int texel = 0; texel < texels; texel++) {
                int column = texel % shape.u().count();
                int row = texel / shape.u().count();
                boolean seen = slice < shape.slicesAt(column, row);
                for (int c = 0; c < CHANNELS; c++) {
                    double color = grid.level().scale() * square(grid.roots()[slice][CHANNELS * texel + c]);
                    steps[c] = (int) Math.round(Math.log1p(color / FLOOR) / Math.log(2) / octaves);
                }
                for (int c = 0; c < CHANNELS; c++) {
                    int guess = before[c][texel]
                            + guess(now[c], before[c], texel, column, shape.u().count());
                    // Y first, then X and Z beside it; what no directions see is as guessed.
                    int wanted = c == 0 ? steps[1] : steps[c == 1 ? 0 : 2] - steps[1];
                    int rest = seen ? wanted - guess : 0;
                    int code = rest < 0 ? -2 * rest - 1 : 2 * rest;
                    now[c][texel] = guess + rest;
                    codes[2 * c * all + slice * texels + texel] = (byte) code;
                    codes[(2 * c + 1) * all + slice * texels + texel] = (byte) (code >> Byte.SIZE);
                }
                for (int c = 0; c < CHANNELS; c++) {
                    most = seen ? Math.max(most, steps[c]) : most;
                    double color = FLOOR * Math.expm1(steps[c] * octaves * Math.log(2));
                    rounded.roots()[slice][CHANNELS * texel + c] =
                            seen ? (float) Math.sqrt(color / grid.level().scale()) : 0;
                }
            }
            before = now;
        }
        return new QuantizedGrid(rounded, Deflated.of(codes, Deflater.BEST_COMPRESSION), most);
    }

    private static double square(double value) {
        return value * value;
    }

    /** The median of what the neighbors' differences to the slice before are, and of the plane through them. */
    private static int guess(int[] now, int[] before, int texel, int column, int columns) {
        int left = column == 0 ? 0 : now[texel - 1] - before[texel - 1];
        int below = texel < columns ? 0 : now[texel - columns] - before[texel - columns];
        int corner = column == 0 || texel < columns ? 0 : now[texel - columns - 1] - before[texel - columns - 1];
        int low = Math.min(left, below);
        int high = Math.max(left, below);
        return corner >= high ? low : corner <= low ? high : left + below - corner;
    }
}
