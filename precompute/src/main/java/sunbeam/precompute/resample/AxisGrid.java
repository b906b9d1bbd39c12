package sunbeam.precompute.resample;

/** Equally spaced frequencies along one axis: sample i has the frequency (first + i) * step, cycles per meter. */
public record AxisGrid(int first, int count, double step) {

    /** Covers an interval of frequencies, with a margin of samples on both sides. */
    public static AxisGrid covering(double low, double high, double step, int margin) {
        int first = (int) Math.floor(low / step) - margin;
        int last = (int) Math.ceil(high / step) + margin;
        return new AxisGrid(first, last - first + 1, step);
    }

    public AxisGrid extended(int newCount) {
        return new AxisGrid(first, Math.max(count, newCount), step);
    }
}
