package jrtr;

/** Measures rendering. */
public interface GpuTimer extends Resource {

    /**
     * Runs the work and waits until the device has done it. The driver's timer query is taken where there is one and its
     * answer is possible (above 0, not above the wall clock's time); the wall clock's time otherwise.
     *
     * @param work draws in the timer's context; must not measure, itself
     * @throws IllegalStateException if a measurement of the same context is under way
     */
    GpuTime measure(Runnable work);
}
