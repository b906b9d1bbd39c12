package sunbeam.app.cli.export;

import java.util.stream.LongStream;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.method.ColorTablePlan;

/** Axes of a color grid, with at least {@link TableDesign#TAPS} slices of |w|, and the largest angle to the normal, radians. */
record GridShape(Axis u, Axis v, Axis depth, double largestAngle) {
    /** Largest |(u, v)|, and largest |w|, of any two directions. */
    static final double REACH = 2;
    // Wavelength, meters, for which the step is chosen: in blue light orders are narrowest.
    private static final double SHARPEST_WAVELENGTH = 450e-9;

    /** Axis of a grid: equally spaced values, at least one; the step is positive. */
    record Axis(double first, double step, int count) {
        static Axis covering(double from, double to, double step) {
            int count = 1 + (int) Math.ceil((to - from) / step);
            return new Axis(0.5 * (from + to - (count - 1) * step), step, count);
        }

        /** Returns an axis extended on both sides to a multiple of {@code multiple} values. */
        Axis padded(int multiple) {
            int more = (multiple - count % multiple) % multiple;
            int before = more / 2;
            return new Axis(first - before * step, step, count + more);
        }

        /** Returns an axis whose values are means of {@code factor} values each. */
        Axis coarser(int factor) {
            return new Axis(first + 0.5 * (factor - 1) * step, factor * step, count / factor);
        }

        double at(int index) {
            return first + index * step;
        }

        /** Returns the fractional index of a value, clamped to 0 to count - 1. */
        double place(double value) {
            return Math.max(0, Math.min(count - 1.0, (value - first) / step));
        }
    }

    record Box(double left, double right, double bottom, double top) {
        static Box of(double radius) {
            return new Box(-radius, radius, -radius, radius);
        }

        Box clipped(double fromU, double toU, double fromV, double toV) {
            return new Box(inside(fromU), inside(toU), inside(fromV), inside(toV));
        }

        private double inside(double value) {
            return Math.max(left, Math.min(right, value));
        }
    }

    /** Returns the coarsest shape that keeps the plan's tolerance: linear in the square roots along u and v, cubic in the colors along w. */
    static GridShape of(ColorTablePlan plan, ColorTable.Level level, Box box, double largestAngle) {
        double tolerance = plan.table().tolerance();
        double step = Math.sqrt(8 * tolerance) * level.area().window().sigmaOfOrder(SHARPEST_WAVELENGTH);
        double sliceStep =
                TableDesign.within(tolerance, level.area(), plan.relief()).sliceStep();
        double least = REACH * Math.cos(largestAngle);
        int slices = Math.max(TableDesign.TAPS, 1 + (int) Math.ceil((REACH - least) / sliceStep));
        Axis depth = new Axis(least, (REACH - least) / (slices - 1), slices);
        Axis u = Axis.covering(box.left, box.right, step);
        Axis v = Axis.covering(box.bottom, box.top, step);
        return new GridShape(u, v, depth, largestAngle);
    }

    /** Returns the largest |(u, v)|. */
    double radius() {
        return REACH * Math.sin(largestAngle);
    }

    GridShape coarser(int factor) {
        return new GridShape(u.coarser(factor), v.coarser(factor), depth, largestAngle);
    }

    int texels() {
        return Math.multiplyExact(u.count(), v.count());
    }

    long allTexels() {
        return (long) u.count() * v.count() * depth.count();
    }

    long evaluated() {
        return LongStream.range(0, (long) u.count() * v.count())
                .map(this::slicesAt)
                .sum();
    }

    double uAt(long texel) {
        return u.at((int) (texel % u.count()));
    }

    double vAt(long texel) {
        return v.at((int) (texel / u.count()));
    }

    /** Returns the number of slices from the first that any two directions reach at the (u, v) of a texel, counted row by row. */
    int slicesAt(long texel) {
        double radius = Math.max(0, Math.hypot(uAt(texel), vAt(texel)) - 1.5 * u.step());
        if (radius > radius()) {
            return 0;
        }
        double deepest = Math.sqrt(Math.max(0, REACH * REACH - radius * radius));
        return firstSlice(depth.place(deepest)) + TableDesign.TAPS;
    }

    int firstSlice(double place) {
        return Math.max(0, Math.min((int) place - 1, depth.count() - TableDesign.TAPS));
    }
}
