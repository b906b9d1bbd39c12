package sunbeam.app.accuracy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.certificate.ErrorStatistics;
import sunbeam.app.certificate.RelativeError;

/**
 * The page that shows the figures of some patches, in Markdown.
 *
 * @param figures of each patch by name
 * @param counts how many directions were asked for
 * @param renderer that drew, as OpenGL names it
 */
record AccuracyPage(Map<String, List<ErrorFigure>> figures, SampleCounts counts, String renderer) {
    private static final String INTRODUCTION = """
            # Accuracy

            How wrong method `full` is, against the exact `reference` (direct sums in double precision), and what each of
            its choices has to do with it. Made by `./sunbeam accuracy` on %s.

            Directions are random (seed %d): half of them uniform on the hemisphere, for light and view alike, half aimed at
            diffraction orders of the patch. Those whose power, or largest of X, Y, Z of power, is below %.0e are left out.
            Of each patch, %d directions with a wavelength for power and %d for X, Y, Z; half as many for the thesis's plan,
            whose window lies on the corner and which is compared with exact values for that window. The error of a colour is
            the largest difference in X, Y or Z over the largest of the three.

            The thesis's settings (37 Taylor terms of mean-centred heights, 3 x 3 bins around the floored one, 5 nm) are a
            point in every plot, each with everything else as good as it gets, save in the plots over tolerance, where it is
            the whole preset (it has no tolerance: its points stand at the right edge).

            ## Tolerance asked for, error measured

            Wanted: a median of at most the tolerance and a 95th percentile of at most three times it.

            | patch | quantity | tolerance | directions | median | 95th percentile | maximum | |
            |---|---|---|---|---|---|---|---|
            """;

    private static final String REMARKS = """

            ## Patch by patch

            Terms: power, the other choices exact (`double`: terms summed over the surface in double precision; `float32`:
            tables and shader, 7 x 7 bins). Taylor's terms grow before they shrink and cancel, which float32 cannot follow;
            the low-rank basis is limited to 1e-10 by its singular values. Neighbourhood: power. Wavelength step: X, Y, Z with
            7 x 7 bins. Every plot has its table (CSV: median, 95th percentile, maximum).
            """;

    /** Name of a figure's files without extension. */
    static String stem(String patch, ErrorFigure figure) {
        return patch + "-" + figure.key();
    }

    String text() {
        StringBuilder page = new StringBuilder(
                INTRODUCTION.formatted(renderer, counts.seed(), RelativeError.FLOOR, counts.powers(), counts.colors()));
        figures.forEach((patch, all) -> all.stream()
                .filter(figure -> figure.style() == ErrorFigure.Style.AGAINST_TOLERANCE)
                .forEach(figure -> addTolerances(page, patch, figure)));
        page.append(REMARKS);
        figures.forEach((patch, all) -> {
            page.append("\n### ").append(patch).append("\n\n");
            for (ErrorFigure figure : all) {
                String stem = stem(patch, figure);
                page.append("![%s](%s.png)\n([table](%s.csv))\n\n".formatted(figure.title(), stem, stem));
            }
        });
        return page.toString().stripTrailing() + "\n";
    }

    private static void addTolerances(StringBuilder page, String patch, ErrorFigure figure) {
        for (ErrorCurve curve : figure.curves()) {
            for (int i = 0; i < curve.x().size(); i++) {
                double tolerance = curve.x().get(i);
                ErrorStatistics errors = curve.errors().get(i);
                String verdict = errors.meets(tolerance) ? "kept" : "**missed**";
                addRow(page, patch, curve.name(), number("%.0e", tolerance), errors, verdict);
            }
        }
        for (ErrorCurve point : figure.thesis()) {
            addRow(page, patch, point.name(), "", point.errors().get(0), "");
        }
    }

    private static void addRow(
            StringBuilder page, String patch, String name, String tolerance, ErrorStatistics errors, String verdict) {
        String[] cells = {
            patch,
            name,
            tolerance,
            Integer.toString(errors.count()),
            number("%.1e", errors.median()),
            number("%.1e", errors.percentile95()),
            number("%.1e", errors.maximum()),
            verdict
        };
        page.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
