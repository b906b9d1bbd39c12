package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Text: a matrix of numbers from the top row, or points x y z on a grid, below any header. Known headers are those of
 * Gwyddion (in all its languages), SPIP, Park's XEI and WSxM; numbers may have decimal commas and any line ends.
 */
public final class TextReader implements ScanReader {
    private static final int POINT = 3;
    /** As few triples on no grid may well be a matrix of three columns. */
    private static final int SURELY_POINTS = 16;

    private static final Pattern AXES = Pattern.compile(
            "(?i)[#%;*\\s\"]*x\\s*[\\[(]([^\\])]+)[\\])]\\W+y\\s*[\\[(]([^\\])]+)[\\])]\\W+z\\s*[\\[(]([^\\])]+)[\\])].*");

    @Override
    public String format() {
        return "text";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return TextHead.of(TextBytes.of(file)).isPresent();
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        TextBytes text = TextBytes.of(file);
        TextHead head = TextHead.of(text).orElseThrow();
        TextFacts facts = TextFacts.of(head.header());
        TextNumbers numbers = TextNumbers.count(text, head);
        boolean matrix = facts.width().isPresent() || facts.columns().isPresent();
        if (!matrix && numbers.columns() == POINT && numbers.isRectangular() && numbers.rows() > POINT) {
            Optional<ScanChannel> points = points(head, numbers);
            if (points.isPresent()) {
                return List.of(points.get());
            }
        }
        return List.of(matrix(facts, numbers));
    }

    private static ScanChannel matrix(TextFacts facts, TextNumbers numbers) {
        if (facts.columns().isEmpty()) {
            numbers.requireRectangular();
        }
        long columns = facts.columns().map(Integer::longValue).orElse(numbers.columns());
        if (columns < 1) {
            throw new ScanException("has no numbers in its first row; export it again");
        }
        boolean asSaid = facts.columns().isPresent() && facts.rows().isPresent();
        long rows = asSaid ? facts.rows().get() : numbers.count() / columns;
        if (columns * rows != numbers.count()) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d numbers where its header announces %d x %d; export it again",
                    numbers.count(),
                    columns,
                    rows));
        }
        Extent extent = new Extent(facts.width(), facts.height(), 1);
        return new ScanChannel(facts.channel(), toInt(columns), toInt(rows), extent, facts.unit(), () -> {
            double[] heights = numbers.read();
            CountedLines.refuse(heights, toInt(columns));
            return heights;
        });
    }

    private static int toInt(long count) {
        return (int) Math.min(count, Integer.MAX_VALUE);
    }

    private static Optional<ScanChannel> points(TextHead head, TextNumbers numbers) throws IOException {
        double[][] xyz = numbers.readColumns(POINT);
        Optional<PointGrid> found = PointGrid.of(xyz[0], xyz[1], xyz[2]);
        if (found.isEmpty()) {
            if (numbers.rows() >= SURELY_POINTS) {
                throw new ScanException("has three numbers a line whose first two are no points of a grid; interpolate"
                        + " the points in Gwyddion and export a matrix or .gwy");
            }
            return Optional.empty();
        }
        PointGrid grid = found.get();
        Optional<Matcher> axes = head.header().stream()
                .map(AXES::matcher)
                .filter(Matcher::matches)
                .findFirst();
        String unitX = axes.map(matcher -> matcher.group(1)).orElse("");
        String unitY = axes.map(matcher -> matcher.group(2)).orElse("");
        double metresY =
                LengthUnit.metres(unitY).orElse(1.0) / LengthUnit.metres(unitX).orElse(1.0);
        Extent extent = Extent.ofPitches(
                grid.axisX().pitch(),
                grid.axisY().pitch() * metresY,
                unitX,
                grid.axisX().count(),
                grid.axisY().count());
        return Optional.of(new ScanChannel(
                "z",
                grid.axisX().count(),
                grid.axisY().count(),
                extent,
                axes.map(matcher -> matcher.group(3)).orElse(""),
                grid::heights));
    }
}
