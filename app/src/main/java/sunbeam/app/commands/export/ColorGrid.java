package sunbeam.app.commands.export;

import java.util.Arrays;
import sunbeam.precompute.colortable.ColorColumns;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Colors C(u, v, w) of the ensemble's average under a window, on a grid, each texel of (u, v) of which is a column to whoever
 * evaluates them.
 *
 * @param level the window, and what its power counts beside that of the window that was asked for
 * @param shape where texels lie
 * @param roots square roots of X, Y, Z by slice; rows of ascending v, in them ascending u
 */
record ColorGrid(ColorTable.Level level, GridShape shape, float[][] roots) implements ColorColumns {
    static final int CHANNELS = 3;
    // Darker than what any certificate compares.
    private static final double DARK = 1e-10;
    private static final double FARTHEST = 2;

    static ColorGrid empty(ColorTable.Level level, GridShape shape) {
        return new ColorGrid(level, shape, new float[shape.depth().count()][CHANNELS * shape.texels()]);
    }

    /** X, Y, Z of power, as whoever reads a file is told to find them. */
    double[] xyz(double u, double v, double w) {
        double column = shape.u().place(u);
        double row = shape.v().place(v);
        int left = Math.max(0, Math.min((int) column, shape.u().count() - 2));
        int below = Math.max(0, Math.min((int) row, shape.v().count() - 2));
        double place = shape.depth().place(-w);
        int first = shape.firstSlice(place);
        double[] xyz = new double[CHANNELS];
        for (int slice = first; slice < first + TableDesign.TAPS; slice++) {
            double weight = level.scale() * Lagrange.weight(place - first, slice - first, TableDesign.TAPS);
            for (int c = 0; c < CHANNELS; c++) {
                double root = mix(
                        mix(root(slice, left, below, c), root(slice, left + 1, below, c), column - left),
                        mix(root(slice, left, below + 1, c), root(slice, left + 1, below + 1, c), column - left),
                        row - below);
                xyz[c] += weight * root * root;
            }
        }
        Arrays.setAll(xyz, c -> Math.max(0, xyz[c]));
        return xyz;
    }

    private double root(int slice, int column, int row, int channel) {
        int inRow = Math.min(column, shape.u().count() - 1);
        int inColumn = Math.min(row, shape.v().count() - 1);
        return roots[slice][CHANNELS * (inColumn * shape.u().count() + inRow) + channel];
    }

    private static double mix(double from, double to, double share) {
        return from + share * (to - from);
    }

    /** The least part of the plane outside of which all is dark; all where there is no light. */
    GridShape.Box lit() {
        GridAxis u = shape.u();
        GridAxis v = shape.v();
        int left = u.count();
        int right = -1;
        int bottom = v.count();
        int top = -1;
        for (float[] slice : roots) {
            for (int i = 0; i < slice.length; i++) {
                if ((double) slice[i] * slice[i] > DARK) {
                    int texel = i / CHANNELS;
                    left = Math.min(left, texel % u.count());
                    right = Math.max(right, texel % u.count());
                    bottom = Math.min(bottom, texel / u.count());
                    top = Math.max(top, texel / u.count());
                }
            }
        }
        return right < 0
                ? GridShape.Box.of(shape.range())
                : new GridShape.Box(
                        inside(u.at(left - 1)),
                        inside(u.at(right + 1)),
                        inside(v.at(bottom - 1)),
                        inside(v.at(top + 1)));
    }

    private double inside(double value) {
        double radius = shape.range().radius();
        return Math.max(-radius, Math.min(radius, value));
    }

    @Override
    public int count() {
        return shape.texels();
    }

    @Override
    public void locate(int column, float[] uv) {
        double u = shape.u().at(column % shape.u().count());
        double v = shape.v().at(column / shape.u().count());
        double inside = Math.min(1, FARTHEST / Math.max(FARTHEST, Math.hypot(u, v)));
        uv[0] = (float) (inside * u);
        uv[1] = (float) (inside * v);
    }

    @Override
    public double[] depths() {
        return shape.depth().values(1);
    }

    @Override
    public int asked(int column, int[] slices) {
        int count =
                shape.slicesAt(column % shape.u().count(), column / shape.u().count());
        for (int i = 0; i < count; i++) {
            slices[i] = i;
        }
        return count;
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        roots[slice][CHANNELS * column] = (float) Math.abs(x);
        roots[slice][CHANNELS * column + 1] = (float) Math.abs(y);
        roots[slice][CHANNELS * column + 2] = (float) Math.abs(z);
    }
}
