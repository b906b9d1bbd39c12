package sunbeam.app.measure.benchmark;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * The times and errors of one patch as text.
 *
 * @param patch its name
 * @param size width and height of the maps, pixels
 * @param frames that were timed of each
 * @param light where it comes from
 * @param samples views that were asked for
 * @param seed of the views
 */
record BenchmarkReport(String patch, int size, int frames, String light, int samples, long seed) {

    /** @param times the thesis's first */
    void print(PrintWriter out, String renderer, List<FrameTime> times) {
        FrameTime thesis = times.get(0);
        out.printf(
                Locale.ROOT,
                "BRDF map of %s, %d x %d, %d covered pixels, light at %s%n%s, %d processors, %s, median of %d frames%n",
                patch,
                size,
                size,
                thesis.coveredPixels(),
                light,
                renderer,
                Runtime.getRuntime().availableProcessors(),
                thesis.clock(),
                frames);
        if (samples > 0) {
            out.printf(
                    Locale.ROOT,
                    "error of X, Y, Z against the reference: up to %d random views of this light (seed %d), half of them aimed at"
                            + " orders%n",
                    samples,
                    seed);
        }
        out.println();
        out.println(
                "                              making  shader               per    times faster,        error of XYZ");
        out.println(
                "  method                      tables  upload     frame    pixel  drawing  1st frame  median   95 %  views");
        times.forEach(time -> line(out, time, thesis));
        out.println();
        times.forEach(time -> out.println(
                "  " + time.contender().name() + ": " + time.contender().description()));
    }

    private static void line(PrintWriter out, FrameTime time, FrameTime thesis) {
        out.printf(
                Locale.ROOT,
                "  %-24s %7.2f s %5.2f s %7.4f s %s %8.1f %10.2f  %s%n",
                time.contender().name(),
                time.tableSeconds(),
                time.uploadSeconds(),
                time.frameSeconds(),
                perPixel(time.microsecondsPerPixel()),
                thesis.frameSeconds() / time.frameSeconds(),
                thesis.firstFrameSeconds() / time.firstFrameSeconds(),
                time.errors().map(BenchmarkReport::errors).orElse("not measured"));
    }

    private static String perPixel(double microseconds) {
        return String.format(
                Locale.ROOT,
                microseconds < 1 ? "%5.0f ns" : "%5.1f us",
                microseconds < 1 ? 1e3 * microseconds : microseconds);
    }

    private static String errors(ErrorStatistics errors) {
        return errors.count() == 0
                ? "all views are dark"
                : String.format(Locale.ROOT, "%7.1e %7.1e %5d", errors.median(), errors.percentile95(), errors.count());
    }
}
