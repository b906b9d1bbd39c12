package jrtr;

/**
 * How long a piece of rendering took.
 *
 * @param nanoseconds above 0
 * @param source which clock said so
 */
public record GpuTime(long nanoseconds, Source source) {

    /** Kinds of clock. */
    public enum Source {
        /** The driver's own clock, from the first command's start to the last one's end on the device. */
        TIMER_QUERY,
        /** The machine's clock, from an idle device to an idle device; the calling program's own work is in it. */
        WALL_CLOCK
    }

    /** The same in seconds. */
    public double seconds() {
        return nanoseconds * 1e-9;
    }
}
