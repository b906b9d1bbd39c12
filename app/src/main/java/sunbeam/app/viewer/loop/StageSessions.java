package sunbeam.app.viewer.loop;

import java.util.List;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneSession;
import sunbeam.app.render.SceneShape;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSharing;

/** Sessions that hold a scene, as drawn by one method, on the graphics card, and its measured cost. Used by the render thread only. */
final class StageSessions implements AutoCloseable {
    private final RenderContext context;
    TimedTiles tiles;
    FrameScale scale;
    /** One for each look, patch and Fresnel component; empty before the first update. */
    List<SceneSession> parts = List.of();

    private SceneData scaled;
    // Session without diffraction until the first update; null afterwards.
    private SceneSession body;

    StageSessions(RenderContext context) {
        this.context = context;
    }

    SceneSession open(Scene scene, SceneShape shape) {
        body = new SceneSession(context, scene, shape);
        return body;
    }

    /** Switches to another scene; if that fails, the old one stays. */
    void update(List<SceneData> wanted) {
        if (parts.size() == wanted.size()) {
            List<SceneData> before = parts.stream().map(SceneSession::data).toList();
            try {
                updateParts(wanted);
            } catch (RuntimeException | OutOfMemoryError failure) {
                updateParts(before);
                throw failure;
            }
        } else {
            replace(wanted);
        }
        followCost(wanted.get(0));
    }

    private void updateParts(List<SceneData> data) {
        for (int i = 0; i < parts.size(); i++) {
            parts.get(i).update(data.get(i));
        }
    }

    private void replace(List<SceneData> wanted) {
        SceneSession first = body != null ? body : new SceneSession(context, wanted.get(0));
        body = null;
        List<SceneSession> made = Resource.orClose(() -> SceneSession.all(first, wanted), first::close);
        close();
        parts = made;
    }

    private void followCost(SceneData data) {
        if (scaled == null
                || !SceneSharing.isSame(data.method(), scaled.method())
                || !SceneSharing.isSame(data.shape().whole(), scaled.shape().whole())) {
            scale = new FrameScale();
            tiles = new TimedTiles(this::pixelClock);
        }
        scaled = data;
    }

    /** Clock, in nanoseconds, that runs while pixels are shaded but not while the mesh is rasterized. */
    long pixelClock() {
        return System.nanoTime()
                - parts.stream().mapToLong(SceneSession::meshNanoseconds).sum();
    }

    PartSum sum() {
        return new PartSum(parts);
    }

    Stream<VirtualTexture> colors() {
        return parts.stream().flatMap(part -> part.virtualTexture().stream());
    }

    @Override
    public void close() {
        parts.forEach(SceneSession::close);
        parts = List.of();
        if (body != null) {
            body.close();
            body = null;
        }
    }

    /**
     * Chooses the resolution of pictures drawn while something moves: the finest scale whose frames take at most {@link
     * #BUDGET_NANOSECONDS}, else the coarsest. Measured times decay, so that finer scales are tried again.
     */
    static final class FrameScale {
        /** Time of a frame at 30 frames a second. */
        static final long BUDGET_NANOSECONDS = 33_000_000;

        // Divisors of width and height, by scale. Coarser pictures would be unrecognizable.
        private static final double[] DIVISORS = {1, 1.25, 1.6, 2, 3, 4};
        private static final double DECAY = 0.99;
        // A scale over budget is recorded as SLOW times its time, at most SLOWEST budgets. After one to three seconds
        // this has decayed below the budget, and the scale is tried again.
        private static final double SLOW = 1.5;
        private static final double SLOWEST = 2.5;
        private static final double NEWEST = 0.25;

        // Index: scale; 0 before the first frame.
        private final double[] recorded = new double[DIVISORS.length];
        private int scale;
        // Time of the last frame at the current scale, and running mean, in nanoseconds; 0 before the first.
        private long previous;
        private double mean;

        double divisor() {
            return DIVISORS[scale];
        }

        void frame(long nanoseconds) {
            for (int i = 0; i < recorded.length; i++) {
                recorded[i] *= DECAY;
            }
            // The first frame waits for the driver, and other programs can delay single ones: take the shorter of two.
            if (previous > 0) {
                long least = Math.min(previous, nanoseconds);
                mean = mean == 0 ? least : mean + NEWEST * (least - mean);
                recorded[scale] =
                        mean > BUDGET_NANOSECONDS ? Math.min(SLOW * mean, SLOWEST * BUDGET_NANOSECONDS) : mean;
            }
            previous = nanoseconds;
            int finest = 0;
            while (finest < recorded.length - 1 && recorded[finest] > BUDGET_NANOSECONDS) {
                finest++;
            }
            if (finest != scale) {
                scale = finest;
                previous = 0;
                mean = 0;
            }
        }
    }
}
