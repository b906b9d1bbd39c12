package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import jrtr.GraphicsException;

/**
 * Keeps faults around OpenGL from ending the process, or from misleading the user. Four come from outside: an X server that goes away,
 * upon which Xlib ends the process of the next caller; an exit beside a thread that draws, which crashes the driver; stack traces that
 * JOGL prints; and folders that JOGL unpacks its native libraries into. The state is that of the process, as the display is.
 */
public final class DisplayFaults {
    private static final Pattern DISPLAY = Pattern.compile("(?:unix/?)?([^:/]*):(\\d{1,5})(?:\\.\\d+)?");
    private static final int FIRST_PORT = 6000;
    private static final int LAST_DISPLAY = 0xffff - FIRST_PORT;

    /** A driver that compiles a long shader takes seconds; one that hangs must not keep the process. */
    private static final long DRAWING_NANOSECONDS = TimeUnit.SECONDS.toNanos(10);
    /** A context that is being made while the process ends may wait for a thread that cannot be started any more. */
    private static final long OPENING_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(500);

    private static final String OPERATIONS = DisplayFaults.class.getPackageName() + ".";
    private static final String TEMPORARY_FOLDER = "java.io.tmpdir";

    private static final AtomicReference<Runnable> LOSS = new AtomicReference<>(() -> {});
    private static final List<Thread> DRAWING = new CopyOnWriteArrayList<>();
    private static final List<Thread> OPENING = new CopyOnWriteArrayList<>();
    private static final List<Thread> RESTING = new CopyOnWriteArrayList<>();
    private static boolean prepared;
    private static volatile boolean ending;

    private DisplayFaults() {}

    /**
     * Sets the action, on a thread of its own, for the end of the X server: it ends the process without Java's shutdown hooks, since JOGL's
     * call Xlib. Threads that draw are at rest by then.
     */
    public static void onLoss(Runnable action) {
        LOSS.set(action);
    }

    /**
     * Prepares the process for contexts. Must precede all use of JOGL, so that the end of the server is seen here first.
     *
     * @throws GraphicsException if there is no folder for JOGL's libraries
     */
    static synchronized void prepare() {
        if (prepared) {
            return;
        }
        hideTraces();
        if (!"false".equals(System.getProperty("jogamp.gluegen.UseTempJarCache"))) {
            makeLibraryFolder();
        }
        watch(System.getenv().getOrDefault("DISPLAY", ""), () -> {
            awaitRest();
            LOSS.get().run();
        });
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(DisplayFaults::awaitRest, "jrtr-end"));
        } catch (IllegalStateException shuttingDown) {
            ending = true;
        }
        prepared = true;
    }

    /** Drops what JOGL prints on standard error: stack traces while it looks for drivers, and lists of displays at the end. */
    private static void hideTraces() {
        PrintStream original = System.err;
        System.setErr(new PrintStream(
                new OutputStream() {
                    @Override
                    public void write(int character) {
                        write(new byte[] {(byte) character}, 0, 1);
                    }

                    @Override
                    public void write(byte[] bytes, int offset, int length) {
                        if (!isCalledByJogl()) {
                            original.write(bytes, offset, length);
                        }
                    }
                },
                true,
                StandardCharsets.UTF_8));
    }

    private static boolean isCalledByJogl() {
        return StackWalker.getInstance()
                .walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
                        .anyMatch(name -> name.startsWith("com.jogamp.") || name.startsWith("jogamp.")));
    }

    /**
     * Gives JOGL a new folder of a random name that its owner alone may enter, removed at the end. JOGL's own folder has a predictable
     * name, so that another user could create it first and replace a library.
     */
    private static void makeLibraryFolder() {
        String shared = System.getProperty(TEMPORARY_FOLDER);
        try {
            Path folder = Files.createTempDirectory(Path.of(shared), "jrtr-libraries-");
            Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(folder), "jrtr-libraries"));
            System.setProperty(TEMPORARY_FOLDER, folder.toString());
            // JOGL asks once and remembers; it passes over folders that are full or take no programs.
            if (!IOUtil.getTempDir(true).toPath().toRealPath().startsWith(folder.toRealPath())) {
                throw new IOException("it is full, or programs must not run there");
            }
        } catch (IOException | RuntimeException failure) {
            throw new GraphicsException(
                    "JOGL's native libraries cannot be unpacked to the folder for temporary files, " + shared + " ("
                            + failure.getMessage()
                            + "). Free some space there, or name another folder with -Djava.io.tmpdir=FOLDER",
                    failure);
        } finally {
            System.setProperty(TEMPORARY_FOLDER, shared);
        }
    }

    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        } catch (IOException | RuntimeException left) {
            // Still in use (on Windows).
        }
    }

    /** Runs an action when the server of a display has gone; where there is none, there is nothing to lose. */
    static void watch(String display, Runnable loss) {
        Matcher parts = DISPLAY.matcher(display);
        if (!parts.matches() || Integer.parseInt(parts.group(2)) > LAST_DISPLAY) {
            return;
        }
        SocketAddress address = parts.group(1).isEmpty()
                ? UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + parts.group(2))
                : new InetSocketAddress(parts.group(1), FIRST_PORT + Integer.parseInt(parts.group(2)));
        connect(address).ifPresent(first -> {
            Thread thread = new Thread(
                    () -> {
                        awaitEnd(address, first);
                        loss.run();
                    },
                    "jrtr-display");
            thread.setDaemon(true);
            thread.start();
        });
    }

    private static Optional<SocketChannel> connect(SocketAddress address) {
        try {
            return Optional.of(SocketChannel.open(address));
        } catch (IOException | RuntimeException gone) {
            return Optional.empty();
        }
    }

    /** Servers also drop idle clients, and all clients when they reset: the server has gone once it takes no other connection. */
    private static void awaitEnd(SocketAddress address, SocketChannel first) {
        Optional<SocketChannel> server = Optional.of(first);
        while (server.isPresent()) {
            try (SocketChannel open = server.get()) {
                while (open.read(ByteBuffer.allocate(1)) >= 0) {
                    // Servers do not write to clients that ask nothing.
                }
            } catch (IOException reset) {
                // An end, too.
            }
            server = connect(address);
            // A server with too many clients drops a new one at once.
            server.ifPresent(again -> sleep(1000));
        }
    }

    /** The calling thread is about to make a context and to draw, until {@link #stopDrawing}. */
    static void startDrawing() {
        DRAWING.add(Thread.currentThread());
        OPENING.add(Thread.currentThread());
    }

    /** The calling thread's context is there, or could not be made. */
    static void opened() {
        OPENING.remove(Thread.currentThread());
    }

    /** A context of the calling thread has been closed, or could not be made. */
    static void stopDrawing() {
        DRAWING.remove(Thread.currentThread());
    }

    /** Must precede each operation: while the process ends, finishes those before and stays here for ever. */
    static void pass(GL3 gl) {
        if (ending) {
            gl.glFinish();
            RESTING.add(Thread.currentThread());
            while (true) {
                sleep(TimeUnit.DAYS.toMillis(1));
            }
        }
    }

    /**
     * Returns when each thread that draws is between two operations, where it stays, or after a time. The C library's exit runs the destructors
     * of the driver and of LLVM; beside a thread that compiles or draws they crash the virtual machine.
     */
    static void awaitRest() {
        ending = true;
        long start = System.nanoTime();
        while (DRAWING.stream().anyMatch(thread -> mustWait(thread, System.nanoTime() - start))) {
            sleep(5);
        }
    }

    private static boolean mustWait(Thread thread, long waited) {
        return waited < (OPENING.contains(thread) ? OPENING_NANOSECONDS : DRAWING_NANOSECONDS)
                && !RESTING.contains(thread)
                && Stream.of(thread.getStackTrace())
                        .anyMatch(frame -> frame.getClassName().startsWith(OPERATIONS));
    }

    private static void sleep(long milliseconds) {
        try {
            TimeUnit.MILLISECONDS.sleep(milliseconds);
        } catch (InterruptedException ending) {
            // These threads have no other work, and the process is about to end: the wait goes on.
        }
    }
}
