package sunbeam.app.measure.benchmark;

import java.util.List;
import java.util.Locale;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;

/**
 * A run in words, part by part: Markdown that a terminal shows, too.
 *
 * @param renderer that OpenGL names
 * @param light where it comes from
 * @param size width and height of the maps, pixels
 * @param frames that are timed of each
 * @param views at which errors are measured
 * @param seed of the views
 */
record BenchmarkPage(String renderer, String light, int size, int frames, int views, long seed) {

    /** What is measured, by what, and how. */
    String introduction() {
        return String.format(
                Locale.ROOT,
                """
                # Error and time

                `sunbeam benchmark`, %s, %d processors.

                - Maps of %d x %d pixels, light at %s.
                - Time: median of %d frames after one for warming up; of short frames as many as take %.1f s, of slow ones those that
                  end within %.0f s. On a shared machine only ratios mean something: to the thesis's shader (`full --preset thesis`).
                - Making: from the heights to what the shader reads, on the card, nothing from the cache. First picture: making and a
                  frame, as a ratio.
                - Error: of X, Y, Z, relative to the largest of them, against `reference` under the method's own window and average,
                  at up to %d random views of that light (seed %d), half of them aimed at orders, of power above %.0e. CIEDE2000:
                  median, at the map's automatic exposure.
                """,
                renderer,
                Runtime.getRuntime().availableProcessors(),
                size,
                size,
                light,
                frames,
                FrameTimer.LEAST_SECONDS,
                FrameTimer.MOST_SECONDS,
                views,
                seed,
                RelativeError.FLOOR);
    }

    /**
     * Every method's error and time on one patch.
     *
     * @param rows the thesis's first
     * @param remarks what is not measured, and why
     */
    String methods(List<Measured> rows, List<String> remarks) {
        Measured thesis = rows.get(0);
        MarkdownTable table = new MarkdownTable(
                "method",
                "median",
                "95 %",
                "CIEDE2000",
                "views",
                "per pixel",
                "times faster",
                "making / s",
                "first picture",
                "MB");
        StringBuilder plans = new StringBuilder();
        for (Measured row : rows) {
            ErrorStatistics errors = row.errors().map(Measured.Errors::relative).orElse(ErrorStatistics.of());
            table.row(
                    row.method(),
                    error(errors.median()),
                    error(errors.percentile95()),
                    row.errors()
                            .map(measured -> figures(measured.colorDifference().median()))
                            .orElse(""),
                    row.errors().isPresent() ? Integer.toString(errors.count()) : "",
                    perPixel(row.microsecondsPerPixel()),
                    figures(row.timesFaster(thesis)),
                    figures(row.makingSeconds()),
                    figures(row.timesFasterToFirstPicture(thesis)),
                    figures(row.bytes() * 1e-6));
            plans.append("- ")
                    .append(row.method())
                    .append(": ")
                    .append(row.plan())
                    .append('\n');
        }
        String clock = String.format(
                Locale.ROOT,
                "%d covered pixels, wall clock around glFinish.",
                thesis.timing().pixels());
        return String.format(
                Locale.ROOT, "%n## %s%n%n%s%n%s%n%n%s%s", thesis.patch(), table, clock, plans, lines(remarks));
    }

    /** How the cost of a patch grows. */
    String growth(String patch, List<Growth> growths) {
        StringBuilder text = new StringBuilder(String.format(
                Locale.ROOT,
                "%n## How cost grows%n%n`full` and `table` at tolerance 1e-2 on %s; maps of %d x %d pixels unless said otherwise.%n",
                patch,
                size,
                size));
        for (Growth growth : growths) {
            MarkdownTable table =
                    new MarkdownTable(growth.axis(), "method", "making / s", "a frame / s", "per pixel", "MB");
            for (Growth.Point point : growth.points()) {
                Measured measured = point.measured();
                table.row(
                        figures(point.x()),
                        measured.method(),
                        figures(measured.makingSeconds()),
                        figures(measured.frameSeconds()),
                        perPixel(measured.microsecondsPerPixel()),
                        figures(measured.bytes() * 1e-6));
            }
            text.append(String.format(Locale.ROOT, "%n%s%s", table, lines(growth.remarks())));
        }
        return text.toString();
    }

    private static String lines(List<String> remarks) {
        StringBuilder text = new StringBuilder();
        remarks.forEach(remark -> text.append('\n').append(remark).append(".\n"));
        return text.toString();
    }

    private static String error(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.1e", value);
    }

    private static String perPixel(double microseconds) {
        return microseconds < 1
                ? String.format(Locale.ROOT, "%.0f ns", 1e3 * microseconds)
                : figures(microseconds) + " us";
    }

    /** Three figures, without an exponent where they are not tiny. */
    private static String figures(double value) {
        if (Double.isNaN(value)) {
            return "";
        }
        return String.format(Locale.ROOT, value >= 1000 || value == Math.rint(value) ? "%.0f" : "%.3g", value);
    }
}
