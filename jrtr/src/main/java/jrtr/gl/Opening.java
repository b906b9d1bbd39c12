package jrtr.gl;

import java.util.function.Supplier;

/** Opens what others have been opened for. */
public final class Opening {
    private Opening() {}

    /**
     * Opens something; if that fails, others are closed, in the order in which they are given.
     *
     * @param others how to close each of them
     */
    public static <T> T orClose(Supplier<T> opening, Runnable... others) {
        try {
            return opening.get();
        } catch (RuntimeException | OutOfMemoryError failure) {
            for (Runnable other : others) {
                other.run();
            }
            throw failure;
        }
    }
}
