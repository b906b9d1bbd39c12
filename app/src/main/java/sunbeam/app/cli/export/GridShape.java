package sunbeam.app.cli.export;

import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.optics.CoherenceWindow;

/** Axes of a color grid for some angles of light and view; slices of |w|, at least {@link TableDesign#TAPS}, are its depth. */
record GridShape(Axis u, Axis v, Axis depth, AngleRange range) {
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

    record AngleRange(double largest) {
        double radius() {
            return REACH * Math.sin(largest);
        }
    }

    record Box(double left, double right, double bottom, double top) {
        static Box of(AngleRange range) {
            double radius = range.radius();
            return new Box(-radius, radius, -radius, radius);
        }
    }

    /** Returns the coarsest shape that keeps a tolerance: linear in the square roots along u and v, cubic in the colors along w. */
    static GridShape within(double tolerance, ColorTable.Level level, double relief, Box box, AngleRange range) {
        double step = Math.sqrt(8 * tolerance) * sigma(level.area().window(), SHARPEST_WAVELENGTH);
        double sliceStep = TableDesign.within(tolerance, level.area(), relief).sliceStep();
        double least = REACH * Math.cos(range.largest);
        int slices = Math.max(TableDesign.TAPS, 1 + (int) Math.ceil((REACH - least) / sliceStep));
        Axis depth = new Axis(least, (REACH - least) / (slices - 1), slices);
        return new GridShape(
                Axis.covering(box.left, box.right, step), Axis.covering(box.bottom, box.top, step), depth, range);
    }

    /** Standard deviation in (u, v) of a sharp order seen under a window. */
    static double sigma(CoherenceWindow window, double wavelength) {
        return wavelength * window.sigmaFrequency() / Math.sqrt(2);
    }

    GridShape padded(int halvings) {
        return new GridShape(u.padded(1 << halvings), v.padded(1 << halvings), depth, range);
    }

    GridShape coarser(int factor) {
        return new GridShape(u.coarser(factor), v.coarser(factor), depth, range);
    }

    int texels() {
        return Math.multiplyExact(u.count(), v.count());
    }

    long allTexels() {
        return (long) u.count() * v.count() * depth.count();
    }

    long evaluated() {
        long sum = 0;
        for (int row = 0; row < v.count(); row++) {
            for (int column = 0; column < u.count(); column++) {
                sum += slicesAt(column, row);
            }
        }
        return sum;
    }

    /** Returns the number of slices from the first that any two directions of the range reach at this (u, v). */
    int slicesAt(int column, int row) {
        double radius = Math.max(0, Math.hypot(u.at(column), v.at(row)) - 1.5 * u.step());
        if (radius > range.radius()) {
            return 0;
        }
        double deepest = Math.sqrt(Math.max(0, REACH * REACH - radius * radius));
        return firstSlice(depth.place(deepest)) + TableDesign.TAPS;
    }

    int firstSlice(double place) {
        return Math.max(0, Math.min((int) place - 1, depth.count() - TableDesign.TAPS));
    }
}
