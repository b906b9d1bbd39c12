package sunbeam.app.measure.accuracy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiConsumer;
import sunbeam.app.measure.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;

/**
 * The page that shows the figures of some patches, in Markdown.
 *
 * @param patches by name: what they are
 * @param figures of each patch by name, of those that are done
 * @param counts how many directions were asked for
 * @param renderer that drew, as OpenGL names it
 */
// Texts of a page stand apart from what fills them.
@SuppressWarnings("InlineFormatString")
record AccuracyPage(
        Map<String, String> patches, Map<String, List<Figure>> figures, SampleCounts counts, String renderer) {
    private static final String INTRODUCTION = """
            # Accuracy

            How wrong Sunbeam is, above all method `full`, against the exact `reference` (direct sums in double precision), and what each of
            its choices has to do with it. Made by `./sunbeam accuracy` on %s.

            %s
            Directions are random (seed %d): half of them uniform on the hemisphere, for light and view alike, half aimed at
            diffraction orders of the patch. Those whose power, or largest of X, Y, Z of power, is below %.0e are left out.
            Of each patch, %d directions with a wavelength for power and %d for X, Y, Z; half as many for the thesis's plan,
            whose window lies on the corner and which is compared with exact values for that window. The error of a colour is
            the largest difference in X, Y or Z over the largest of the three.

            The thesis's settings (37 Taylor terms of mean-centred heights, 3 x 3 bins around the floored one, 5 nm) are a
            point in every plot, each with everything else as good as it gets, save in the plots over tolerance, where it is
            the whole preset (it has no tolerance: its points stand at the right edge).

            ## Tolerance asked for, error measured

            Wanted: a median of at most the tolerance and a 95th percentile of at most three times it, for 1e-2, 1e-3 and 1e-4.
            1e-5 is the finest that can be asked for; there float32 decides. With few directions a 95th percentile is nearly the
            maximum. `brdf-map --certify N` measures the error of one map.

            | patch | quantity | tolerance | directions | median | 95th percentile | maximum | |
            |---|---|---|---|---|---|---|---|
            """;

    private static final String METHODS = """

            ## Where each method stands

            Error of X, Y, Z against `reference` (Gaussian window) on the same directions, and time per pixel of a BRDF map lit
            from the normal, with the plan that such a map needs: the fastest of three frames after one, since other work on
            the machine only adds. `./sunbeam benchmark` times larger maps. `nmm` takes one wavelength per diffraction order; it is meant for patches of one period, on larger ones the orders overlap. `pq` replaces the
            Gaussian window by replicas with sharp edges, whose light falls between the orders differently: its error here is
            that of the model. Against the exact sum over the replicas, which `brdf-map --method pq --certify N` takes, `sinc` errs
            by 1e-4 and less; `linear` loses light between the bins of the DFT (docs/methods.md). `gem` knows a grating's spacing and nothing else.

            | patch | method | median | 95th percentile | us per pixel | times faster | approximates something else |
            |---|---|---|---|---|---|---|
            """;

    private static final String REMARKS = """

            ## Patch by patch

            Terms: power, the other choices exact (`double`: terms summed over the surface in double precision; `float32`:
            tables and shader, 7 x 7 bins). Taylor's terms grow before they shrink and cancel, which float32 cannot follow;
            the low-rank basis is limited to 1e-10 .. 1e-8 by its singular values. Neighbourhood: power. Wavelength step: X, Y, Z with
            7 x 7 bins. Every plot has its table (CSV: median, 95th percentile, maximum).
            """;

    /** Name of a figure's files without extension. */
    static String stem(String patch, Figure figure) {
        return patch + "-" + figure.key();
    }

    String text() {
        StringBuilder page = new StringBuilder(String.format(
                Locale.ROOT,
                INTRODUCTION,
                renderer,
                list(),
                counts.seed(),
                RelativeError.FLOOR,
                counts.powers(),
                counts.colors()));
        each(ErrorFigure.class, (patch, figure) -> {
            if (figure.style() == ErrorFigure.Style.AGAINST_TOLERANCE) {
                addTolerances(page, patch, figure);
            }
        });
        page.append(METHODS);
        each(MethodsFigure.class, (patch, figure) -> addMethods(page, patch, figure));
        page.append(REMARKS);
        figures.forEach((patch, all) -> {
            page.append("\n### ").append(patch).append("\n\n");
            all.forEach(figure -> addFigure(page, patch, figure));
        });
        return page.toString().stripTrailing() + "\n";
    }

    /** Which patches. */
    private String list() {
        StringBuilder lines = new StringBuilder();
        figures.keySet()
                .forEach(name -> lines.append(String.format(Locale.ROOT, "- %s: %s\n", name, patches.get(name))));
        return lines.toString();
    }

    private <F extends Figure> void each(Class<F> kind, BiConsumer<String, F> action) {
        figures.forEach((patch, all) ->
                all.stream().filter(kind::isInstance).map(kind::cast).forEach(figure -> action.accept(patch, figure)));
    }

    private static void addFigure(StringBuilder page, String patch, Figure figure) {
        String stem = stem(patch, figure);
        page.append(String.format(Locale.ROOT, "![%s](%s.png)\n([table](%s.csv))\n\n", figure.title(), stem, stem));
        figure.remarks().forEach(remark -> page.append(remark).append("\n\n"));
    }

    private static void addMethods(StringBuilder page, String patch, MethodsFigure figure) {
        for (MethodsFigure.Entry entry : figure.entries()) {
            ErrorStatistics errors = entry.errors();
            addRow(
                    page,
                    patch,
                    entry.name(),
                    number("%.1e", errors.median()),
                    number("%.1e", errors.percentile95()),
                    figures(entry.microseconds()),
                    figures(figure.speed(entry)),
                    entry.note());
        }
    }

    private static void addTolerances(StringBuilder page, String patch, ErrorFigure figure) {
        for (ErrorCurve curve : figure.curves()) {
            for (int i = 0; i < curve.x().size(); i++) {
                double tolerance = curve.x().get(i);
                ErrorStatistics errors = curve.errors().get(i);
                String verdict = errors.meets(tolerance) ? "kept" : "**missed**";
                addErrors(page, patch, curve.name(), ErrorFigure.number(tolerance), errors, verdict);
            }
        }
        for (ErrorCurve point : figure.thesis()) {
            addErrors(page, patch, point.name(), "", point.errors().get(0), "");
        }
    }

    private static void addErrors(
            StringBuilder page, String patch, String name, String tolerance, ErrorStatistics errors, String verdict) {
        addRow(
                page,
                patch,
                name,
                tolerance,
                Integer.toString(errors.count()),
                number("%.1e", errors.median()),
                number("%.1e", errors.percentile95()),
                number("%.1e", errors.maximum()),
                verdict);
    }

    private static void addRow(StringBuilder page, String... cells) {
        page.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    /** Three figures, without an exponent. */
    private static String figures(double value) {
        return number(value < 1000 ? "%.3g" : "%.0f", value);
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
