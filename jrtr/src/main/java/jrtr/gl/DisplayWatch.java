package jrtr.gl;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tells when the X server that contexts are on has gone. Xlib ends the process of whoever calls it then, in the midst of
 * anything and by a crash of the virtual machine; a connection of our own, on which nothing is asked, ends at the same
 * moment, before anybody calls. The server has gone once it takes no other connection. A matter of the whole process, as
 * its display is.
 */
public final class DisplayWatch {
    private static final Pattern DISPLAY = Pattern.compile("(?:unix/?)?([^:/]*):(\\d{1,5})(?:\\.\\d+)?");
    private static final int FIRST_PORT = 6000;
    private static final int LAST_DISPLAY = 0xffff - FIRST_PORT;
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

    /** Starts watching the display; once for the process, and before anybody else connects, so that its end is seen first. */
    public static void start() {
        if (STARTED.compareAndSet(false, true)) {
            watch(System.getenv().getOrDefault("DISPLAY", ""), () -> {
                EndOfProcess.awaitRest();
                LOSS.get().run();
            });
        }
    }

    /** Runs something when the server has gone; where nobody answers, there is nothing to lose. */
    static void watch(String display, Runnable loss) {
        Optional<SocketAddress> address = address(display);
        Optional<SocketChannel> first = address.flatMap(DisplayWatch::connect);
        if (first.isPresent()) {
            Thread thread = new Thread(
                    () -> {
                        awaitEnd(address.get(), first);
                        loss.run();
                    },
                    "jrtr-display");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private static Optional<SocketAddress> address(String display) {
        Matcher parts = DISPLAY.matcher(display);
        if (!parts.matches() || Integer.parseInt(parts.group(2)) > LAST_DISPLAY) {
            return Optional.empty();
        }
        return Optional.of(
                parts.group(1).isEmpty()
                        ? UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + parts.group(2))
                        : new InetSocketAddress(parts.group(1), FIRST_PORT + Integer.parseInt(parts.group(2))));
    }

    private static Optional<SocketChannel> connect(SocketAddress address) {
        try {
            return Optional.of(SocketChannel.open(address));
        } catch (IOException | RuntimeException gone) {
            return Optional.empty();
        }
    }

    /** Servers let go of those who say nothing for a minute, and of all when they start anew: then it goes on with the next. */
    private static void awaitEnd(SocketAddress address, Optional<SocketChannel> first) {
        Optional<SocketChannel> server = first;
        while (server.isPresent()) {
            long start = System.nanoTime();
            try (SocketChannel open = server.get()) {
                ByteBuffer nothing = ByteBuffer.allocate(1);
                while (open.read(nothing.clear()) >= 0) {
                    // Servers say nothing to those who say nothing.
                }
            } catch (IOException reset) {
                // An end, too.
            }
            server = connect(address);
            if (server.isPresent()) {
                pauseUnlessLong(start);
            }
        }
    }

    /** A server that lets go at once, as one with too many clients does, is not asked without a pause. */
    private static void pauseUnlessLong(long start) {
        if (System.nanoTime() - start < TimeUnit.SECONDS.toNanos(1)) {
            try {
                TimeUnit.SECONDS.sleep(1);
            } catch (InterruptedException impatient) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
