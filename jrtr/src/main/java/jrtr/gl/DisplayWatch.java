package jrtr.gl;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Tells when the X server that contexts are on has gone. Xlib ends the process of whoever calls it then, in the midst of
 * anything and by a crash of the virtual machine; a connection of our own, on which nothing is asked, ends at the same
 * moment, before anybody calls. A matter of the whole process, as its display is.
 *
 * <p>A server that does not let this second connection in is not watched.
 */
public final class DisplayWatch {
    private static final AtomicReference<Runnable> LOSS = new AtomicReference<>(() -> {});
    private static final AtomicBoolean STARTED = new AtomicBoolean();

    private DisplayWatch() {}

    /**
     * Sets what is done, on a thread of its own, when the server has gone after a context was opened: to end the process
     * without running Java's shutdown hooks, since JOGL's would call Xlib. Threads that draw are at rest by then.
     */
    public static void onLoss(Runnable action) {
        LOSS.set(action);
    }

    /** Starts watching the display of these variables of the environment; once for the process. */
    static void start(Map<String, String> environment) {
        if (STARTED.compareAndSet(false, true)) {
            watch(environment, () -> {
                EndOfProcess.awaitRest();
                LOSS.get().run();
            });
        }
    }

    /** @param loss run when a connection that the server has let in ends */
    static Thread watch(Map<String, String> environment, Runnable loss) {
        Thread thread = new Thread(
                () -> {
                    if (isLost(environment)) {
                        loss.run();
                    }
                },
                "jrtr-display");
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Waits for the end of a connection; false at once where there can be none. */
    private static boolean isLost(Map<String, String> environment) {
        try (SocketChannel server = DisplayConnection.open(environment)) {
            awaitEnd(server);
            return true;
        } catch (IOException | IllegalArgumentException refused) {
            return false;
        }
    }

    /** Reads and drops what servers tell all clients. */
    private static void awaitEnd(SocketChannel server) {
        ByteBuffer events = ByteBuffer.allocate(1024);
        try {
            while (server.read(events.clear()) >= 0) {
                // Keyboard mappings and the like.
            }
        } catch (IOException reset) {
            // An end, too.
        }
    }
}
