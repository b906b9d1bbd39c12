package sunbeam.app.cli.export;

import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * Axes of a color grid: texels at regular u, v and w.
 *
 * @param depth slices of |w|, at least {@link TableDesign#TAPS}
 * @param range angles of light and view that the grid serves
 */
record GridShape(GridAxis u, GridAxis v, GridAxis depth, AngleRange range) {
    /** Largest |(u, v)|, and largest |w|, of any two directions. */
    private static final double REACH = 2;
    // Wavelength, meters, for which the step is chosen: in blue light orders are narrowest, and linear interpolation
    // errs most.
    private static final double SHARPEST_WAVELENGTH = 450e-9;

    record AngleRange(double largest) {
        double radius() {
            return REACH * Math.sin(largest);
        }

        double leastDepth() {
            return REACH * Math.cos(largest);
        }
    }

    record Box(double left, double right, double bottom, double top) {
        static Box of(AngleRange range) {
            double radius = range.radius();
            return new Box(-radius, radius, -radius, radius);
        }
    }

    /**
     * Returns the coarsest shape whose interpolation keeps a tolerance: linear in the square roots along u and v, cubic in the colors along
     * w.
     */
    static GridShape within(double tolerance, ColorTable.Level level, double relief, Box box, AngleRange range) {
        double step = Math.sqrt(8 * tolerance) * sigma(level.area().window(), SHARPEST_WAVELENGTH);
        double sliceStep = TableDesign.within(tolerance, level.area(), relief).sliceStep();
        double least = range.leastDepth();
        int slices = Math.max(TableDesign.TAPS, 1 + (int) Math.ceil((REACH - least) / sliceStep));
        GridAxis depth = new GridAxis(least, (REACH - least) / (slices - 1), slices);
        return new GridShape(
                GridAxis.covering(box.left, box.right, step),
                GridAxis.covering(box.bottom, box.top, step),
                depth,
                range);
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

    /** Returns the number of texels, over all slices, that any two directions of the range reach. */
    long evaluated() {
        long sum = 0;
        for (int row = 0; row < v.count(); row++) {
            for (int column = 0; column < u.count(); column++) {
                sum += slicesAt(column, row);
            }
        }
        return sum;
    }

    /** Returns the number of slices, counted from the first, that any two directions of the range reach at this (u, v). */
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
