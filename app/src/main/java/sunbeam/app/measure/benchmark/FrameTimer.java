package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import jrtr.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.precompute.optics.Direction;

/**
 * Times BRDF maps: the median of some frames after one for warming up. Of short frames, which other work disturbs the most,
 * there are as many as take half a second together; slow ones end after {@link #MOST_SECONDS}, which may be the first.
 *
 * @param context in which methods live
 * @param size width and height of the maps, pixels
 * @param frames that are timed, unless they are short or slow
 */
record FrameTimer(RenderContext context, int size, int frames) {
    static final double LEAST_SECONDS = 0.5;
    static final double MOST_SECONDS = 5;
    private static final int MOST_FRAMES = 1000;

    /**
     * What a map takes.
     *
     * @param seconds median over the frames
     * @param pixels of the disc
     * @param exposure the map's automatic exposure, a factor for linear XYZ
     */
    record Timing(double seconds, int pixels, double exposure) {}

    /** Times a method's map of one light. */
    Timing time(UploadedTables method, Direction light) {
        try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size)) {
            List<Double> seconds = new ArrayList<>();
            double warm = seconds(renderer, light);
            double total = 0;
            if (warm > MOST_SECONDS) {
                // What a first frame takes besides, a compilation, is little beside it.
                seconds.add(warm);
                total = warm;
            }
            while (total < LEAST_SECONDS || (seconds.size() < frames && total < MOST_SECONDS)) {
                double frame = seconds(renderer, light);
                seconds.add(frame);
                // A clock that stands still would never come there.
                total += Math.max(frame, LEAST_SECONDS / MOST_FRAMES);
            }
            Collections.sort(seconds);
            return new Timing(
                    seconds.get(seconds.size() / 2), renderer.coveredPixels(), AutoExposure.of(renderer.picture()));
        }
    }

    /** From an idle device to an idle device. */
    private double seconds(BrdfMapRenderer renderer, Direction light) {
        context.finish();
        long start = System.nanoTime();
        renderer.draw(light, pixels -> {});
        context.finish();
        return Math.max(1, System.nanoTime() - start) * 1e-9;
    }
}
