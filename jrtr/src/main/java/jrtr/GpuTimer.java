package jrtr;

/** Measures rendering. */
public interface GpuTimer extends Resource {

    /**
     * Runs the work and waits until the device has done it. A graphics card's timer query is taken if its answer is
     * possible (above 0, not above the wall clock's time); otherwise, and with software renderers, whose queries proved
     * wrong, the wall clock's time from idle device to idle device. {@link GpuTime#source} says which.
     *
     * @param work draws in the timer's context; must not measure, itself
     * @throws IllegalStateException if a measurement of the same context is under way
     */
    GpuTime measure(Runnable work);
}
