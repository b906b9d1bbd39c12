package jrtr.gl;

import java.util.concurrent.atomic.AtomicInteger;

/** How many resources of all contexts of the process are open: what a run of hours must not see grow. */
public final class OpenResources {
    private static final AtomicInteger COUNT = new AtomicInteger();

    private OpenResources() {}

    /** Textures, targets, buffers, programs and timers that were made and not yet closed. */
    public static int count() {
        return COUNT.get();
    }

    static void opened() {
        COUNT.incrementAndGet();
    }

    static void closed() {
        COUNT.decrementAndGet();
    }
}
