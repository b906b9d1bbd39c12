package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.GL3;
import java.io.IOException;
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
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import jrtr.GraphicsException;

/**
 * Keeps faults around OpenGL from ending the process, or from misleading the user. There are four. When the X server goes away, the next
 * call of Xlib ends the process with a stack trace. An exit during a draw of another thread crashes in the driver. JOGL prints stack
 * traces. JOGL unpacks its native libraries into a folder with a predictable name. The state is static, since the display belongs to the
 * whole process.
 */
public final class DisplayFaults {
    private static final Pattern DISPLAY = Pattern.compile("(?:unix/?)?([^:/]*):(\\d{1,5})(?:\\.\\d+)?");
    private static final int FIRST_PORT = 6000;
    /** Longest wait for a drawing thread at the end: compiling a long shader takes seconds, but a driver may hang. */
    private static final long DRAWING_NANOSECONDS = TimeUnit.SECONDS.toNanos(10);
    /** Longest wait for a thread that opens a context: it may itself wait for a thread that no longer starts while the process ends. */
    private static final long OPENING_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(500);

    private static final String TEMPORARY_FOLDER = "java.io.tmpdir";
    private static volatile Runnable onLoss = () -> {};
    private static volatile boolean ending;
    private static boolean prepared;

    private DisplayFaults() {}

    /**
     * Sets the action that runs, on a thread of its own, after the X server has gone. It must end the process without Java's shutdown hooks,
     * since JOGL's hooks call Xlib.
     */
    public static void onLoss(Runnable action) {
        onLoss = action;
    }

    /** Must precede all use of JOGL, so that this class notices the end of the server before Xlib does. */
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
            onLoss.run();
        });
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(DisplayFaults::awaitRest, "jrtr-end"));
        } catch (IllegalStateException shuttingDown) {
            ending = true;
        }
        // Runs before JOGL's shutdown code, which would wait forever for a helper thread that JOGL is then starting.
        NativeWindowFactory.addCustomShutdownHook(true, DisplayFaults::awaitRest);
        prepared = true;
    }

    /** JOGL prints stack traces while it searches drivers, and lists of displays at the end. */
    private static void hideTraces() {
        System.setErr(new PrintStream(System.err, true, StandardCharsets.UTF_8) {
            @Override
            public void write(byte[] bytes, int offset, int length) {
                boolean isCalledByJogl = StackWalker.getInstance()
                        .walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
                                .anyMatch(name -> name.startsWith("com.jogamp.") || name.startsWith("jogamp.")));
                if (!isCalledByJogl) {
                    super.write(bytes, offset, length);
                }
            }
        });
    }

    /**
     * Gives JOGL a new folder with a random name, which only the user may enter and which is removed at the end. JOGL's own folder has a
     * predictable name, so that another user could create it first and replace a library.
     */
    private static void makeLibraryFolder() {
        String shared = System.getProperty(TEMPORARY_FOLDER);
        try {
            Path folder = Files.createTempDirectory(Path.of(shared), "jrtr-libraries-");
            Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(folder), "jrtr-libraries"));
            System.setProperty(TEMPORARY_FOLDER, folder.toString());
            // JOGL reads the property once and skips folders that are full or forbid programs.
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

    /** Removes a folder, except for files that are still in use (on Windows). */
    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder())
                    .forEach(file -> file.toFile().delete());
        } catch (IOException | RuntimeException left) {
            return;
        }
    }

    static void watch(String display, Runnable loss) {
        Matcher parts = DISPLAY.matcher(display);
        // The pattern takes larger numbers than there are ports.
        if (!parts.matches() || FIRST_PORT + Integer.parseInt(parts.group(2)) > 0xffff) {
            return;
        }
        SocketAddress address = parts.group(1).isEmpty()
                ? UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + parts.group(2))
                : new InetSocketAddress(parts.group(1), FIRST_PORT + Integer.parseInt(parts.group(2)));
        SocketChannel server = connect(address);
        if (server != null) {
            Thread thread = new Thread(() -> runAfterEnd(address, server, loss), "jrtr-display");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private static SocketChannel connect(SocketAddress address) {
        try {
            return SocketChannel.open(address);
        } catch (IOException | RuntimeException gone) {
            return null;
        }
    }

    /**
     * Waits until a server has gone. A lost connection is not enough, since servers drop idle clients, and all clients when they reset:
     * the server must also refuse a new connection.
     */
    private static void runAfterEnd(SocketAddress address, SocketChannel first, Runnable loss) {
        for (SocketChannel server = first; server != null; server = connect(address)) {
            if (server != first) {
                // A server with too many clients drops a new one at once: wait before the next try.
                sleep(1000);
            }
            try (SocketChannel open = server) {
                while (open.read(ByteBuffer.allocate(1)) >= 0) {
                    // Servers do not write to clients that send no request.
                }
            } catch (IOException reset) {
                // This also ends the connection.
            }
        }
        loss.run();
    }

    /** Must precede each operation: when the process is ending, finishes earlier operations and never returns. */
    static void blockIfExiting(GL3 gl) {
        if (ending) {
            gl.glFinish();
            blockForever();
        }
    }

    private static void blockForever() {
        while (true) {
            sleep(TimeUnit.DAYS.toMillis(1));
        }
    }

    /**
     * Waits until each thread is outside of this package or blocked between two operations, or until a time limit. The C library's exit
     * runs the destructors of the driver and of LLVM, which crash the virtual machine if another thread compiles or draws.
     */
    private static void awaitRest() {
        ending = true;
        long start = System.nanoTime();
        while (Thread.getAllStackTraces().values().stream()
                .anyMatch(trace -> mustWait(trace, System.nanoTime() - start))) {
            sleep(5);
        }
    }

    private static boolean mustWait(StackTraceElement[] trace, long waited) {
        List<String> calls = Stream.of(trace)
                .map(frame -> frame.getClassName() + "." + frame.getMethodName())
                .filter(call -> call.startsWith("jrtr.gl."))
                .toList();
        String own = DisplayFaults.class.getName();
        return waited < (calls.contains("jrtr.gl.GlDevice.open") ? OPENING_NANOSECONDS : DRAWING_NANOSECONDS)
                && !calls.stream().allMatch(call -> call.startsWith(own))
                && !calls.contains(own + ".blockForever");
    }

    private static void sleep(long milliseconds) {
        try {
            TimeUnit.MILLISECONDS.sleep(milliseconds);
        } catch (InterruptedException ending) {
            return;
        }
    }
}
