package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;

/**
 * Brings drawing to rest before the process ends. The C library's exit runs the driver's destructors, and LLVM's,
 * beside a thread that still compiles or draws: that crashes the virtual machine now and then after Ctrl-C. So a hook
 * waits until each thread that draws is between two operations, where it stays. Making a context is one, too: JOGL's own
 * hook would wait for ever for a thread of JOGL's that is being started.
 */
final class EndOfProcess {
    /** A driver that compiles a long shader takes seconds; one that hangs must not keep the process. */
    private static final long PATIENCE_NANOSECONDS = TimeUnit.SECONDS.toNanos(10);

    /** A context that is being made waits for threads that cannot be started any more. */
    private static final long OPENING_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(500);

    private static final String OPERATIONS = EndOfProcess.class.getPackageName() + ".";
    private static final List<Thread> OWNERS = new CopyOnWriteArrayList<>();
    private static final List<Thread> OPENING = new CopyOnWriteArrayList<>();
    private static final List<Thread> RESTING = new CopyOnWriteArrayList<>();
    private static volatile boolean near;

    static {
        install();
    }

    private EndOfProcess() {}

    private static void install() {
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(EndOfProcess::awaitRest, "jrtr-end"));
        } catch (IllegalStateException ending) {
            near = true;
        }
    }

    /** The calling thread is about to make a context and to draw, until {@link #forget}. */
    static void watch() {
        OWNERS.add(Thread.currentThread());
        OPENING.add(Thread.currentThread());
    }

    /** The context of the calling thread is there. */
    static void opened() {
        OPENING.remove(Thread.currentThread());
    }

    /** One context of the calling thread has been closed, or could not be made. */
    static void forget() {
        OWNERS.remove(Thread.currentThread());
    }

    /** To be called before each operation: finishes what was asked for and stays here if the process is ending. */
    static void pass(GL3 gl) {
        if (near) {
            gl.glFinish();
            RESTING.add(Thread.currentThread());
            rest();
        }
    }

    private static void rest() {
        while (true) {
            try {
                TimeUnit.DAYS.sleep(1);
            } catch (InterruptedException impatient) {
                // The process is ending: nobody is left who could want this thread for something else.
            }
        }
    }

    /** Returns when each thread that draws is between two operations, where it stays, or after a time. */
    static void awaitRest() {
        near = true;
        long start = System.nanoTime();
        while (OWNERS.stream().anyMatch(owner -> mustWait(owner, System.nanoTime() - start))) {
            try {
                TimeUnit.MILLISECONDS.sleep(5);
            } catch (InterruptedException impatient) {
                return;
            }
        }
    }

    private static boolean mustWait(Thread owner, long waited) {
        return waited < (OPENING.contains(owner) ? OPENING_NANOSECONDS : PATIENCE_NANOSECONDS) && isAtWork(owner);
    }

    private static boolean isAtWork(Thread owner) {
        if (RESTING.contains(owner)) {
            return false;
        }
        for (StackTraceElement frame : owner.getStackTrace()) {
            if (frame.getClassName().startsWith(OPERATIONS)) {
                return true;
            }
        }
        return false;
    }
}
