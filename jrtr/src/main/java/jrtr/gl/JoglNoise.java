package jrtr.gl;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;

/**
 * Keeps the stack traces that JOGL prints while it looks for drivers off the standard error stream: they go to the log
 * instead, at debug level, and only if the search failed. What other threads print in the meantime passes through.
 */
final class JoglNoise implements AutoCloseable {
    private static final System.Logger LOGGER = System.getLogger("jrtr.gl");

    private final PrintStream original = System.err;
    private final Thread caller = Thread.currentThread();
    private final ByteArrayOutputStream caught = new ByteArrayOutputStream();

    private JoglNoise() {}

    static JoglNoise divert() {
        JoglNoise noise = new JoglNoise();
        System.setErr(new PrintStream(noise.new Sorter(), true, StandardCharsets.UTF_8));
        return noise;
    }

    /**
     * To be called when JOGL's native libraries could not be loaded: as the program ends, JOGL calls them all the same,
     * in a thread of its own, and the failure, which has been reported already, would be printed once more.
     */
    static void muteShutdown() {
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {
            boolean known =
                    thread.getName().equals("NativeWindowFactory_ShutdownHook") && failure instanceof LinkageError;
            LOGGER.log(known ? Level.DEBUG : Level.ERROR, "in thread " + thread.getName(), failure);
        });
    }

    /** Forgets what was caught. */
    void discard() {
        caught.reset();
    }

    @Override
    public void close() {
        System.setErr(original);
        if (caught.size() > 0) {
            LOGGER.log(Level.DEBUG, () -> caught.toString(StandardCharsets.UTF_8));
        }
    }

    /** Sends each write where its thread's writes belong. */
    private final class Sorter extends java.io.OutputStream {
        @Override
        public void write(int character) {
            write(new byte[] {(byte) character}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) {
            Thread writer = Thread.currentThread();
            if (writer == caller || writer.getName().endsWith("SharedResourceRunner")) {
                caught.write(bytes, offset, length);
            } else {
                original.write(bytes, offset, length);
            }
        }
    }
}
