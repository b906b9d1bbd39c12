package sunbeam.app.cli.export;

import java.util.stream.IntStream;

/** Axis of a grid: equally spaced values, at least one; the step is positive. */
record GridAxis(double first, double step, int count) {

    /** Returns the shortest axis with this step that covers the interval and has the same center. */
    static GridAxis covering(double from, double to, double step) {
        int count = 1 + (int) Math.ceil((to - from) / step);
        return new GridAxis(0.5 * (from + to - (count - 1) * step), step, count);
    }

    /** Returns an axis of the same step, extended on both sides until the number of values is a multiple of {@code multiple}. */
    GridAxis padded(int multiple) {
        int more = (multiple - count % multiple) % multiple;
        int before = more / 2;
        return new GridAxis(first - before * step, step, count + more);
    }

    /** Returns an axis whose values are means of {@code factor} values each. */
    GridAxis coarser(int factor) {
        return new GridAxis(first + 0.5 * (factor - 1) * step, factor * step, count / factor);
    }

    double at(int index) {
        return first + index * step;
    }

    double[] values(int sign) {
        return IntStream.range(0, count).mapToDouble(index -> sign * at(index)).toArray();
    }

    /** Returns the fractional index of a value, clamped to 0 to count - 1. */
    double place(double value) {
        return Math.max(0, Math.min(count - 1.0, (value - first) / step));
    }
}
