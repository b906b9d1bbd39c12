package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import jrtr.GpuTime;
import jrtr.GpuTimer;
import jrtr.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.precompute.optics.Direction;

/**
 * Times the drawing of BRDF maps: the median of some frames after one for warming up. Of short frames, which other work disturbs the
 * most, there are as many as take half a second together.
 *
 * @param context in which methods live
 * @param size width and height of the maps, pixels
 * @param frames that are timed at least
 */
public record FrameTimer(RenderContext context, int size, int frames) {
    private static final double LEAST_SECONDS = 0.5;
    private static final int MOST_FRAMES = 1000;

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
            List<Double> seconds = new ArrayList<>();
            GpuTime.Source clock = GpuTime.Source.WALL_CLOCK;
            double total = 0;
            while (seconds.size() < frames || total < LEAST_SECONDS) {
                GpuTime time = timer.measure(() -> renderer.draw(light, pixels -> {}));
                seconds.add(time.seconds());
                // A clock that stands still would never come there.
                total += Math.max(time.seconds(), LEAST_SECONDS / MOST_FRAMES);
                clock = time.source();
            }
            Collections.sort(seconds);
            return new Timing(
                    seconds.get(seconds.size() / 2),
                    seconds.get(0),
                    renderer.coveredPixels(),
                    clock == GpuTime.Source.TIMER_QUERY ? "timer query" : "wall clock",
                    setupSeconds);
        }
    }
}
