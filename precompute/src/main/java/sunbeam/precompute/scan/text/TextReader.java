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
 * Text: a matrix of numbers from the top row, or points x y z on a grid, below any header. Numbers may have decimal commas
 * and any line ends.
 *
 * @param decimalMark where the user says it
 */
public record TextReader(Optional<DecimalMark> decimalMark) implements ScanReader {
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
        return TextFile.of(file, decimalMark).isPresent();
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        TextFile text = TextFile.of(file, decimalMark).orElseThrow();
        TextFacts facts = TextFacts.of(text.header());
        TextNumbers numbers = TextNumbers.read(text.numbers());
        boolean matrix = facts.extent().width().isPresent() || facts.columns().isPresent();
        if (!matrix && numbers.columns() == POINT && numbers.isRectangular() && numbers.rows() > POINT) {
            Optional<ScanChannel> points = points(text, numbers);
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
        return new ScanChannel(facts.channel(), (int) columns, (int) rows, facts.extent(), facts.unit(), () -> {
            double[] heights = numbers.all();
            CountedLines.refuse(heights, (int) columns);
            return heights;
        });
    }

    private static Optional<ScanChannel> points(TextFile text, TextNumbers numbers) {
        Optional<PointGrid> found = PointGrid.of(numbers.column(0), numbers.column(1), numbers.column(2));
        if (found.isEmpty()) {
            if (numbers.rows() >= SURELY_POINTS) {
                throw new ScanException("has three numbers a line whose first two are no points of a grid; interpolate"
                        + " the points in Gwyddion and export a matrix or .gwy");
            }
            return Optional.empty();
        }
        PointGrid grid = found.get();
        Optional<Matcher> axes = text.header().stream()
                .map(AXES::matcher)
                .filter(Matcher::matches)
                .findFirst();
        String unitX = axes.map(matcher -> matcher.group(1)).orElse("");
        double metresX = LengthUnit.metres(unitX).orElse(1.0);
        double metresY =
                axes.flatMap(matcher -> LengthUnit.metres(matcher.group(2))).orElse(1.0);
        int columns = grid.axisX().count();
        int rows = grid.axisY().count();
        Extent extent =
                Extent.ofPitches(grid.axisX().pitch(), grid.axisY().pitch() * metresY / metresX, unitX, columns, rows);
        String unit = axes.map(matcher -> matcher.group(3)).orElse("");
        return Optional.of(new ScanChannel(
                "z", columns, rows, extent, unit, () -> grid.heights().clone()));
    }
}
