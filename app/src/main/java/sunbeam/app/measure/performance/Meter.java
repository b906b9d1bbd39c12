package sunbeam.app.measure.performance;

import java.util.Optional;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.measure.benchmark.FrameTimer;
import sunbeam.app.measure.benchmark.MapSamples;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Measures methods by maps lit from the normal. Nothing comes from the cache.
 *
 * @param context in which they draw
 * @param mapSize width and height of the maps, pixels
 * @param frames that are timed; the fastest counts, since other work on the machine only adds
 */
record Meter(RenderContext context, int mapSize, int frames) {
    static final Direction LIGHT = new Direction(0, 0, 1);

    /** The same for maps of another size. */
    Meter of(int size) {
        return new Meter(context, size, frames);
    }

    /**
     * What a method takes.
     *
     * @param exact at which its error is measured; nothing where it is not
     * @param remark what else there is to know
     */
    Measured measure(DiffractionSetup setup, String name, Method method, Optional<MapSamples> exact, String remark) {
        BakeTimes.Clock clock = new BakeTimes.Clock(GpuColours::of);
        long start = System.nanoTime();
        ShaderTables tables =
                setup.freshTables(method.plan(setup.surface(), VisibleRange.of(LIGHT)), MethodUse.COLOUR, clock);
        Optional<BakeTimes> bake = clock.used() ? Optional.of(clock.times()) : Optional.empty();
        try (UploadedTables drawn = UploadedTables.upload(context, tables)) {
            context.finish();
            double making = (System.nanoTime() - start) * 1e-9;
            FrameTimer.Timing timing = new FrameTimer(context, mapSize, frames).time(drawn, LIGHT);
            boolean comparable = method.brightness() == Method.Brightness.OF_A_MIRROR;
            Optional<ErrorStatistics> errors =
                    exact.filter(samples -> comparable).map(samples -> samples.errors(context, method, drawn));
            return new Measured(
                    name,
                    errors,
                    making,
                    bake,
                    timing.fastestSeconds(),
                    timing.fastestMicrosecondsPerPixel(),
                    tables.bytes(),
                    remark);
        }
    }

    /** Time per pixel of a map by what a shader reads, microseconds. */
    double microseconds(ShaderTables tables) {
        try (UploadedTables drawn = UploadedTables.upload(context, tables)) {
            return new FrameTimer(context, mapSize, frames).time(drawn, LIGHT).fastestMicrosecondsPerPixel();
        }
    }
}
