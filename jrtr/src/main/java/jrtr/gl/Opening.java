package jrtr.gl;

import java.util.function.Supplier;

/** Opens a resource that depends on others. */
public final class Opening {
    private Opening() {}

    /** Opens a resource; if that fails, closes the others in the given order. */
    public static <T> T orClose(Supplier<T> opening, Runnable... others) {
        try {
            return opening.get();
        } catch (RuntimeException | Error failure) {
            for (Runnable other : others) {
                other.run();
            }
            throw failure;
        }
    }
}
