package jrtr.gl;

import com.jogamp.nativewindow.NativeWindowFactory;
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

    private static boolean ending;

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
     * Keeps JOGL silent in its own thread at the program's end, where it lists the displays that an interrupted program
     * left open, and stumbles over native libraries that could not be loaded. To be called once, before JOGL starts.
     */
    static void muteShutdown() {
        NativeWindowFactory.addCustomShutdownHook(true, JoglNoise::muteForGood);
    }

    private static void muteForGood() {
        synchronized (JoglNoise.class) {
            ending = true;
            divert();
        }
    }

    void discard() {
        caught.reset();
    }

    @Override
    public void close() {
        synchronized (JoglNoise.class) {
            // A thread that was just opening a context when the program ended would let JOGL speak.
            if (!ending) {
                System.setErr(original);
            }
        }
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
