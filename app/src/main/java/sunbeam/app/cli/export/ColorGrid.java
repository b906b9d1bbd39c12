package sunbeam.app.cli.export;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Ensemble-averaged colors C(u, v, w) on a regular grid, under the window of a color table's level, whose scale converts them to power
 * under the requested window. The square roots of X, Y, Z are by slice of w {@code [(row * columns + column) * 3 + channel]}, v ascending
 * by row.
 */
record ColorGrid(ColorTable.Level level, GridShape shape, float[][] roots) {
    static final int CHANNELS = 3;
    // Power below which a texel counts as dark; a tenth of the least power that errors are measured at.
    private static final double DARK = 1e-10;

    static ColorGrid empty(ColorTable.Level level, GridShape shape) {
        return new ColorGrid(level, shape, new float[shape.depth().count()][CHANNELS * shape.texels()]);
    }

    /** Interpolates X, Y, Z of power by the rule that the files' metadata state. */
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

    static double mix(double from, double to, double share) {
        return from + share * (to - from);
    }

    /** Returns the bounding box, in the (u, v) plane, of all texels that are not dark; the whole range if all are dark. */
    GridShape.Box brightBox() {
        GridShape.Axis u = shape.u();
        GridShape.Axis v = shape.v();
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

    /** Bakes all texels that any two directions reach, sorted by azimuth, so that a batch is a wedge and batches share few rays. */
    void bake(ColorBaker baker, ColorBaker.Token token) {
        int[] byAngle = IntStream.range(0, shape.texels())
                .filter(texel -> slices(texel) > 0)
                .mapToLong(texel -> ((long) Float.floatToIntBits(angle(texel)) << Integer.SIZE) + texel)
                .sorted()
                .mapToInt(key -> (int) key)
                .toArray();
        int next;
        for (int first = 0; first < byAngle.length; first = next) {
            int samples = 0;
            for (next = first; next < byAngle.length && samples <= ColorBaker.LARGEST_BATCH; next++) {
                samples += slices(byAngle[next]);
            }
            bake(Arrays.copyOfRange(byAngle, first, next), samples, baker, token);
        }
    }

    private void bake(int[] texels, int samples, ColorBaker baker, ColorBaker.Token token) {
        float[] uvw = new float[CHANNELS * samples];
        int at = 0;
        for (int texel : texels) {
            double inside = GridShape.REACH / Math.max(GridShape.REACH, Math.hypot(u(texel), v(texel)));
            for (int slice = 0; slice < slices(texel); slice++) {
                uvw[at++] = (float) (inside * u(texel));
                uvw[at++] = (float) (inside * v(texel));
                uvw[at++] = (float) -shape.depth().at(slice);
            }
        }
        float[] xyz = baker.bake(uvw, token);
        at = 0;
        for (int texel : texels) {
            for (int slice = 0; slice < slices(texel); slice++) {
                for (int c = 0; c < CHANNELS; c++) {
                    roots[slice][CHANNELS * texel + c] = (float) Math.sqrt(Math.max(0, xyz[at++]));
                }
            }
        }
    }

    private int slices(int texel) {
        return shape.slicesAt(texel % shape.u().count(), texel / shape.u().count());
    }

    private double u(int texel) {
        return shape.u().at(texel % shape.u().count());
    }

    private double v(int texel) {
        return shape.v().at(texel / shape.u().count());
    }

    /** Returns a texel's azimuth plus pi: a float's bits sort like its value only if it is not negative. */
    private float angle(int texel) {
        return (float) (Math.PI + Math.atan2(v(texel), u(texel)));
    }
}
