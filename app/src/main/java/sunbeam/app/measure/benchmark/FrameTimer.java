package sunbeam.app.measure.benchmark;

import java.util.Arrays;
import jrtr.GpuTime;
import jrtr.GpuTimer;
import jrtr.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.precompute.optics.Direction;

/**
 * Times the drawing of BRDF maps: the median of some frames after one for warming up.
 *
 * @param context in which methods live
 * @param size width and height of the maps, pixels
 * @param frames that are timed
 */
public record FrameTimer(RenderContext context, int size, int frames) {

    /**
     * What a map took.
     *
     * @param seconds median over the frames
     * @param fastestSeconds of one frame: what other work on the machine disturbed least
     * @param coveredPixels pixels of the disc
     * @param clock which clock said so
     * @param setupSeconds compilation of the shader, until the device was idle
     */
    public record Timing(double seconds, double fastestSeconds, int coveredPixels, String clock, double setupSeconds) {

        /** Of the fastest frame. */
        public double fastestMicrosecondsPerPixel() {
            return 1e6 * fastestSeconds / coveredPixels;
        }
    }

    /** Times a method's map of one light. */
    public Timing time(UploadedTables method, Direction light) {
        long start = System.nanoTime();
        try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size);
                GpuTimer timer = context.createTimer()) {
            context.finish();
            double setupSeconds = (System.nanoTime() - start) * 1e-9;
            timer.measure(() -> renderer.draw(light, pixels -> {}));
            double[] seconds = new double[frames];
            GpuTime.Source clock = GpuTime.Source.WALL_CLOCK;
            for (int i = 0; i < frames; i++) {
                GpuTime time = timer.measure(() -> renderer.draw(light, pixels -> {}));
                seconds[i] = time.seconds();
                clock = time.source();
            }
            Arrays.sort(seconds);
            return new Timing(
                    seconds[frames / 2],
                    seconds[0],
                    renderer.coveredPixels(),
                    clock == GpuTime.Source.TIMER_QUERY ? "timer query" : "wall clock",
                    setupSeconds);
        }
    }
}
