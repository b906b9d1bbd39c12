package jrtr.gl;

import com.jogamp.opengl.GL3;
import jrtr.GpuTime;
import jrtr.GpuTime.Source;
import jrtr.GpuTimer;

/**
 * A timer query between two clock readings, both on an idle device.
 *
 * <p>Software renderers' queries are not asked: llvmpipe (Mesa 22.3) claims 64 bits but answers about a twentieth of the
 * time that a draw takes, and its processor is the machine's own, so the wall clock is right.
 */
final class GlTimer extends GlResource implements GpuTimer {
    private final int[] query = new int[1];
    private final boolean hasQueries;

    GlTimer(GlDevice device) {
        super(device, "timer");
        GL3 gl = device.gl();
        hasQueries = device.info().timerQueryBits() > 0 && !device.info().software();
        if (hasQueries) {
            gl.glGenQueries(1, query, 0);
        }
        device.check(gl, "making a timer");
    }

    @Override
    public GpuTime measure(Runnable work) {
        GL3 gl = gl();
        device().beginMeasurement();
        long wallNanoseconds;
        try {
            wallNanoseconds = run(gl, work);
        } finally {
            device().endMeasurement();
        }
        device().check(gl, "measuring time");
        return decide(hasQueries ? queried(gl) : 0, wallNanoseconds);
    }

    private long run(GL3 gl, Runnable work) {
        gl.glFinish();
        long start = System.nanoTime();
        if (hasQueries) {
            gl.glBeginQuery(GL3.GL_TIME_ELAPSED, query[0]);
        }
        try {
            work.run();
        } finally {
            // The work may have made another context of this thread current.
            GL3 again = gl();
            if (hasQueries) {
                again.glEndQuery(GL3.GL_TIME_ELAPSED);
            }
            again.glFinish();
        }
        return System.nanoTime() - start;
    }

    private long queried(GL3 gl) {
        long[] nanoseconds = new long[1];
        gl.glGetQueryObjectui64v(query[0], GL3.GL_QUERY_RESULT, nanoseconds, 0);
        return nanoseconds[0];
    }

    /** The query's answer if it is possible, else the wall clock's; see {@link GpuTimer#measure}. */
    static GpuTime decide(long queriedNanoseconds, long wallNanoseconds) {
        boolean possible = queriedNanoseconds > 0 && queriedNanoseconds <= wallNanoseconds;
        return possible
                ? new GpuTime(queriedNanoseconds, Source.TIMER_QUERY)
                : new GpuTime(Math.max(1, wallNanoseconds), Source.WALL_CLOCK);
    }

    @Override
    void delete(GL3 gl) {
        if (hasQueries) {
            gl.glDeleteQueries(1, query, 0);
        }
    }
}
