package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import jrtr.GraphicsException;

/**
 * Keeps faults around OpenGL from ending the process, or from misleading the user. There are three. An exit during a draw of another
 * thread crashes in the driver. JOGL prints stack traces. JOGL unpacks its native libraries into a folder with a predictable name. The
 * state is static, since the exit belongs to the whole process.
 */
final class DisplayFaults {
    /** Longest wait for a drawing thread at the end: compiling a long shader takes seconds, but a driver may hang. */
    private static final long DRAWING_NANOSECONDS = TimeUnit.SECONDS.toNanos(10);
    /** Longest wait for a thread that opens a context: it may itself wait for a thread that no longer starts while the process ends. */
    private static final long OPENING_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(500);

    private static final String TEMPORARY_FOLDER = "java.io.tmpdir";
    private static volatile boolean ending;
    private static boolean prepared;

    private DisplayFaults() {}

    /** Must precede all use of JOGL. */
    static synchronized void prepare() {
        if (prepared) {
            return;
        }
        hideTraces();
        if (!"false".equals(System.getProperty("jogamp.gluegen.UseTempJarCache"))) {
            makeLibraryFolder();
        }
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
