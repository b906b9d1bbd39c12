package sunbeam.app.measure.benchmark;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * The times and errors of one patch as text.
 *
 * @param patch its name
 * @param size width and height of the maps, pixels
 * @param frames that were timed of each at least
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
                "BRDF map of %s, %d x %d, %d covered pixels, light at %s%n%s, %d processors, %s, median of %d frames or as many as take 0.5 s%n",
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

    /**
     * The same for programs.
     *
     * @param rate directions times wavelengths that the reference computes in a second
     */
    Map<String, Object> fields(String renderer, List<FrameTime> times, double rate) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", patch);
        fields.put("size", size);
        fields.put("coveredPixels", times.get(0).coveredPixels());
        fields.put("light", light);
        fields.put("renderer", renderer);
        fields.put("processors", Runtime.getRuntime().availableProcessors());
        fields.put("clock", times.get(0).clock());
        fields.put("frames", frames);
        fields.put("seed", seed);
        fields.put(
                "methods",
                times.stream().map(time -> fields(time, times.get(0))).toList());
        fields.put("referenceDirectionsTimesWavelengthsPerSecond", rate);
        return fields;
    }

    private static Map<String, Object> fields(FrameTime time, FrameTime thesis) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("method", time.contender().label());
        time.contender().average().ifPresent(average -> fields.put("average", average));
        fields.put("plan", time.contender().description());
        fields.put("tableSeconds", time.tableSeconds());
        fields.put("uploadSeconds", time.uploadSeconds());
        fields.put("frameSeconds", time.frameSeconds());
        fields.put("microsecondsPerPixel", time.microsecondsPerPixel());
        fields.put("timesFasterDrawing", thesis.frameSeconds() / time.frameSeconds());
        fields.put("timesFasterToTheFirstFrame", thesis.firstFrameSeconds() / time.firstFrameSeconds());
        time.errors().filter(errors -> errors.count() > 0).ifPresent(errors -> {
            fields.put("views", errors.count());
            fields.put("medianErrorOfXyz", errors.median());
            fields.put("percentile95ErrorOfXyz", errors.percentile95());
        });
        return fields;
    }

    private static void line(PrintWriter out, FrameTime time, FrameTime thesis) {
        out.printf(
                Locale.ROOT,
                "  %-24s %7.2f s %5.2f s %7.4f s %s %8s %10s  %s%n",
                time.contender().name(),
                time.tableSeconds(),
                time.uploadSeconds(),
                time.frameSeconds(),
                perPixel(time.microsecondsPerPixel()),
                ratio(thesis.frameSeconds() / time.frameSeconds()),
                ratio(thesis.firstFrameSeconds() / time.firstFrameSeconds()),
                time.errors().map(BenchmarkReport::errors).orElse("not measured"));
    }

    /** Runs differ by some per cent: three digits. */
    private static String ratio(double value) {
        return String.format(Locale.ROOT, value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : "%.2f", value);
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
