package sunbeam.app.measure.performance;

import java.util.List;
import java.util.Locale;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;

/**
 * The report in Markdown.
 *
 * @param machine that measured, and how busy it was
 * @param scale what was measured
 * @param folder of the plots, as the page names it
 * @param patches of each its methods
 * @param growths how cost grows
 */
// Texts of a page stand apart from what fills them.
@SuppressWarnings("InlineFormatString")
record PerformancePage(String machine, Scale scale, String folder, List<PatchFigures> patches, List<Growth> growths) {
    private static final String INTRODUCTION = """
            # Speed and error

            What each method costs, and how wrong it is. Made by `./sunbeam performance` on %s.
            Absolute times mean little on a machine that others use; ratios are to the thesis's shader (`full --preset thesis`) in the same
            run.

            BRDF maps of %d x %d pixels, light from the normal; the fastest of %d frames after one, or of as many as take half a
            second. Errors of X, Y, Z are relative to the
            largest of the three, against `reference` (direct sums in double precision) under the method's own window and average, at up to
            %d random views of that light (seed %d), half of them aimed at orders, of power above %.0e; read from the tables that were
            timed. Making is all from the heights to what the shader reads, on the card; first picture: making and one frame, against the
            thesis's. Nothing comes from the cache.

            ## Methods
            """;

    private static final String DHILLON = """

            The look-up of D. Dhillon, J. Teyssier, M. Single, I. Gaponenko, M. Milinkovitch and M. Zwicker, "Interactive Diffraction from
            Biological Nanostructures" (Computer Graphics Forum 33, 2014) tabulates over (u, v) the 2 N + 1 coefficients of a Taylor
            series of the colour in w. The rows take the N out of 5, 10, ... 60 that does best, heights centred on the middle of their
            range, and evaluate the coefficients at each view's own (u, v), so that no grid errs: what is left is the basis. Its terms grow up to
            exp(k |w| relief) before they cancel, so that the deeper the relief and the darker the view, the fewer digits are left, of float32 first,
            then of double; on shallow gratings it is as good as exact. `table` has four slices around w in its place, whose coefficients are at
            most 1.
            """;

    private static final String BAKING = """

            ## Tables of colours over tolerance

            Where the time of making them goes: spectra (Fourier transforms, resampling), graphics (context, upload, compilation), evaluation of
            all places by `full`'s shader, and the rest (places, square roots, the spline's coefficients). A map's look-up is 4 bilinear fetches at any
            tolerance, a list's 16.

            | patch | table | making / s | spectra | graphics | evaluation | rest | million places | us a place | MB | median | 95 %% |
            |---|---|---|---|---|---|---|---|---|---|---|---|
            """;

    private static final String GROWTH = """

            ## How cost grows

            `full` and `table` at tolerance %s on maps of %d x %d pixels unless said otherwise.
            """;

    /** A tolerance for people: 1e-3. */
    static String power(double tolerance) {
        return String.format(Locale.ROOT, "%.0e", tolerance).replace("e-0", "e-");
    }

    /** Name of a plot's file without its ending. */
    static String stem(PatchFigures figures) {
        return figures.patch() + "-methods";
    }

    String text() {
        StringBuilder page = new StringBuilder(String.format(
                Locale.ROOT,
                INTRODUCTION,
                machine,
                scale.mapSize(),
                scale.mapSize(),
                scale.frames(),
                scale.views(),
                MethodsExperiment.SEED,
                RelativeError.FLOOR));
        patches.forEach(figures -> addMethods(page, figures));
        page.append(DHILLON);
        page.append(String.format(Locale.ROOT, BAKING));
        patches.forEach(figures -> figures.baked().forEach(row -> addBake(page, figures.patch(), row)));
        page.append(
                String.format(Locale.ROOT, GROWTH, power(scale.growthTolerance()), scale.mapSize(), scale.mapSize()));
        growths.forEach(growth -> addGrowth(page, growth));
        return page.toString().stripTrailing() + "\n";
    }

    private void addMethods(StringBuilder page, PatchFigures figures) {
        page.append("\n### ").append(figures.patch()).append("\n\n");
        addPicture(page, stem(figures), "error over time");
        addRow(
                page,
                "method",
                "median",
                "95 %",
                "views",
                "per pixel",
                "times faster",
                "making / s",
                "first picture",
                "MB",
                "remark");
        addRow(page, "---", "---", "---", "---", "---", "---", "---", "---", "---", "---");
        Measured thesis = figures.rows().get(0);
        for (Measured row : figures.rows()) {
            addRow(
                    page,
                    row.name(),
                    row.errors().map(errors -> error(errors.median())).orElse(""),
                    row.errors().map(errors -> error(errors.percentile95())).orElse(""),
                    row.errors().map(errors -> Integer.toString(errors.count())).orElse(""),
                    perPixel(row.microseconds()),
                    figures(thesis.microseconds() / row.microseconds()),
                    figures(row.makingSeconds()),
                    figures((thesis.makingSeconds() + thesis.frameSeconds())
                            / (row.makingSeconds() + row.frameSeconds())),
                    row.bytes() == 0 ? "" : figures(row.bytes() * 1e-6),
                    row.remark());
        }
        addRemarks(page, figures.remarks());
    }

    private static void addBake(StringBuilder page, String patch, Measured row) {
        BakeTimes bake = row.bake().orElseThrow();
        addRow(
                page,
                patch,
                row.name().replaceFirst("table, ", ""),
                figures(row.makingSeconds()),
                figures(bake.spectra()),
                figures(bake.graphics()),
                figures(bake.evaluation()),
                figures(bake.rest()),
                figures(bake.places() * 1e-6),
                figures(1e6 * bake.evaluation() / bake.places()),
                figures(row.bytes() * 1e-6),
                row.errors()
                        .map(ErrorStatistics::median)
                        .map(PerformancePage::error)
                        .orElse(""),
                row.errors()
                        .map(ErrorStatistics::percentile95)
                        .map(PerformancePage::error)
                        .orElse(""));
    }

    private void addGrowth(StringBuilder page, Growth growth) {
        page.append("\n### ").append(growth.title()).append("\n\n");
        addPicture(page, growth.key(), growth.title());
        addRow(page, growth.axis(), "method", "making / s", "a frame / s", "per pixel", "MB");
        addRow(page, "---", "---", "---", "---", "---", "---");
        for (Growth.Point point : growth.points()) {
            Measured measured = point.measured();
            addRow(
                    page,
                    figures(point.x()),
                    point.method(),
                    figures(measured.makingSeconds()),
                    figures(measured.frameSeconds()),
                    perPixel(measured.microseconds()),
                    figures(measured.bytes() * 1e-6));
        }
        addRemarks(page, growth.remarks());
    }

    private void addPicture(StringBuilder page, String stem, String title) {
        page.append(String.format(
                Locale.ROOT, "![%s](%s/%s.png)%n([table](%s/%s.csv))%n%n", title, folder, stem, folder, stem));
    }

    private static void addRemarks(StringBuilder page, List<String> remarks) {
        remarks.forEach(remark -> page.append("\n").append(remark).append(".\n"));
    }

    private static void addRow(StringBuilder page, String... cells) {
        page.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    private static String error(double value) {
        return String.format(Locale.ROOT, "%.1e", value);
    }

    private static String perPixel(double microseconds) {
        if (Double.isNaN(microseconds)) {
            return "";
        }
        return microseconds < 1
                ? String.format(Locale.ROOT, "%.0f ns", 1e3 * microseconds)
                : figures(microseconds) + " us";
    }

    /** Three figures, without an exponent. */
    private static String figures(double value) {
        if (Double.isNaN(value)) {
            return "";
        }
        boolean whole = value >= 1000 || value == Math.rint(value);
        return String.format(Locale.ROOT, whole ? "%.0f" : "%.3g", value);
    }
}
