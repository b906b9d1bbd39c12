package sunbeam.app.cli.export;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.work.Progress;

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
        int columns = shape.u().count();
        double place = shape.depth().place(-w);
        int first = shape.firstSlice(place);
        double[] xyz = new double[CHANNELS];
        for (int tap = 0; tap < TableDesign.TAPS; tap++) {
            float[] slice = roots[first + tap];
            double weight = level.scale() * Lagrange.weight(place - first, tap, TableDesign.TAPS);
            for (int c = 0; c < CHANNELS; c++) {
                int channel = c;
                Nodes nodes = (y, x) -> slice[CHANNELS * (y * columns + x) + channel];
                double root = bilinear(row, column, shape.v().count(), columns, nodes);
                xyz[c] += weight * root * root;
            }
        }
        Arrays.setAll(xyz, c -> Math.max(0, xyz[c]));
        return xyz;
    }

    interface Nodes {
        double at(int row, int column);
    }

    /** Interpolates linearly between the nodes around a fractional row and column. */
    static double bilinear(double row, double column, int rows, int columns, Nodes nodes) {
        int below = Math.max(0, Math.min((int) row, rows - 2));
        int above = Math.min(below + 1, rows - 1);
        int left = Math.max(0, Math.min((int) column, columns - 2));
        int right = Math.min(left + 1, columns - 1);
        double low = mix(nodes.at(below, left), nodes.at(below, right), column - left);
        return mix(low, mix(nodes.at(above, left), nodes.at(above, right), column - left), row - below);
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
        GridShape.Box whole = GridShape.Box.of(shape.radius());
        return right < 0 ? whole : whole.clipped(u.at(left - 1), u.at(right + 1), v.at(bottom - 1), v.at(top + 1));
    }

    /** Bakes all texels that any two directions reach, sorted by azimuth, so that a batch is a wedge and batches share few rays. */
    void bake(ColorBaker baker, Progress token) {
        int[] byAngle = IntStream.range(0, shape.texels())
                .filter(texel -> shape.slicesAt(texel) > 0)
                .mapToLong(texel -> {
                    // A float's bits sort like its value only if it is not negative, so pi is added.
                    float azimuth = (float) (Math.PI + Math.atan2(shape.vAt(texel), shape.uAt(texel)));
                    return ((long) Float.floatToIntBits(azimuth) << Integer.SIZE) + texel;
                })
                .sorted()
                .mapToInt(key -> (int) key)
                .toArray();
        int next;
        for (int first = 0; first < byAngle.length; first = next) {
            int samples = 0;
            for (next = first; next < byAngle.length && samples <= ColorBaker.LARGEST_BATCH; next++) {
                samples += shape.slicesAt(byAngle[next]);
            }
            bake(Arrays.copyOfRange(byAngle, first, next), samples, baker, token);
        }
    }

    private void bake(int[] texels, int samples, ColorBaker baker, Progress token) {
        float[] uvw = new float[CHANNELS * samples];
        int at = 0;
        for (int texel : texels) {
            double u = shape.uAt(texel);
            double v = shape.vAt(texel);
            double inside = GridShape.REACH / Math.max(GridShape.REACH, Math.hypot(u, v));
            for (int slice = 0; slice < shape.slicesAt(texel); slice++) {
                uvw[at++] = (float) (inside * u);
                uvw[at++] = (float) (inside * v);
                uvw[at++] = (float) -shape.depth().at(slice);
            }
        }
        float[] xyz = baker.bake(uvw, token);
        at = 0;
        for (int texel : texels) {
            for (int slice = 0; slice < shape.slicesAt(texel); slice++) {
                for (int c = 0; c < CHANNELS; c++) {
                    roots[slice][CHANNELS * texel + c] = (float) Math.sqrt(Math.max(0, xyz[at++]));
                }
            }
        }
    }
}
