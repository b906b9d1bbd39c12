package jrtr.gl;

import java.io.EOFException;
import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.Map;

/**
 * Keeps an X server as it is while a context is opened. Servers start anew when their last client goes, unless told {@code -noreset},
 * and let go of whoever comes in that moment; opening a context connects and disconnects several times.
 */
final class DisplayHold implements AutoCloseable {
    private static final int ATTEMPTS = 10;
    private static final long MILLISECONDS_BETWEEN = 200;

    private final SocketChannel server;

    private DisplayHold(SocketChannel server) {
        this.server = server;
    }

    /**
     * Connects, again and again for 2 s while the server is starting anew. A server that cannot be reached or does not let us in is
     * not held: whoever needs it will say why.
     */
    static DisplayHold take(Map<String, String> environment) {
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            try {
                return new DisplayHold(DisplayConnection.open(environment));
            } catch (EOFException startingAnew) {
                if (!pause()) {
                    break;
                }
            } catch (IOException | IllegalArgumentException refused) {
                break;
            }
        }
        return new DisplayHold(null);
    }

    /** Whether nobody interrupted it. */
    private static boolean pause() {
        try {
            Thread.sleep(MILLISECONDS_BETWEEN);
            return true;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** Whether the server is held. */
    boolean holds() {
        return server != null;
    }

    @Override
    public void close() {
        if (server == null) {
            return;
        }
        try {
            server.close();
        } catch (IOException gone) {
            // What is not there is not held.
        }
    }
}
