package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of text: a matrix of numbers from the top row, or points x y z on a grid, after any header.
 *
 * @param decimalMark the user's choice; empty to detect it
 */
public record TextReader(Optional<DecimalMark> decimalMark) {
    /** x, y, z. */
    private static final int POINT = 3;
    /** This many lines with three numbers must be points; fewer may be a matrix of three columns. */
    private static final int SURELY_POINTS = 16;

    /** This many evenly spaced numbers count as coordinates; fewer may be heights. */
    private static final int FEWEST_EVENLY_SPACED = 8;
    // Share of the step; files round numbers.
    private static final double ROUNDING = 0.2;

    private static final Pattern AXES = Pattern.compile(
            "(?i)[#%;*\\s\"]*x\\s*[\\[(]([^\\])]+)[\\])]\\W+y\\s*[\\[(]([^\\])]+)[\\])]\\W+z\\s*[\\[(]([^\\])]+)[\\])].*");

    public boolean recognizes(ScanBytes file) throws IOException {
        return TextFile.of(file, decimalMark).isPresent();
    }

    /**
     * Reads the single channel of a recognized text.
     *
     * @throws ScanException if the file cannot be used
     */
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        TextFile text = TextFile.of(file, decimalMark).orElseThrow();
        TextFacts facts = TextFacts.of(text.header());
        TextNumbers numbers = text.numbers();
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
        int columns = facts.columns().orElse(numbers.columns());
        boolean announced = facts.columns().isPresent() && facts.rows().isPresent();
        int rows = announced ? facts.rows().get() : numbers.count() / columns;
        if ((long) columns * rows != numbers.count()) {
            throw new ScanException("has " + numbers.count() + " numbers where its header announces " + columns + " x "
                    + rows + "; export it again");
        }
        Samples samples = new Samples(columns, rows, () -> {
            double[] heights = numbers.first(numbers.count());
            refuseCoordinates(heights, columns, rows);
            return heights;
        });
        return new ScanChannel(facts.channel(), samples, facts.extent(), facts.unit());
    }

    /** Refuses profiles, and a first column or row of evenly spaced numbers beside others: coordinates or row numbers. */
    private static void refuseCoordinates(double[] heights, int columns, int rows) {
        if (columns == 2 && rows > 2) {
            throw new ScanException(
                    "has two columns, places and heights: a profile is no surface; export the whole image");
        }
        // The corner, where the first column and row meet, is left out.
        if (columns > 1
                && isEvenlySpaced(heights, columns, columns, rows - 1)
                && !isEvenlySpaced(heights, columns + 1, columns, rows - 1)) {
            throw coordinates("column");
        }
        if (rows > 1
                && isEvenlySpaced(heights, 1, 1, columns - 1)
                && !isEvenlySpaced(heights, columns + 1, 1, columns - 1)) {
            throw coordinates("row");
        }
    }

    private static ScanException coordinates(String line) {
        return new ScanException("has a first " + line + " that counts evenly, as places or numbers of rows do, beside"
                + " others that do not; remove it, so that only heights are left");
    }

    /** True if numbers at a stride are evenly spaced; false for fewer than {@link #FEWEST_EVENLY_SPACED}. */
    private static boolean isEvenlySpaced(double[] numbers, int first, int stride, int count) {
        int last = first + (count - 1) * stride;
        if (count < FEWEST_EVENLY_SPACED || last >= numbers.length) {
            return false;
        }
        double step = (numbers[last] - numbers[first]) / (count - 1);
        boolean even = Math.abs(step) > 0;
        for (int i = 0; i < count && even; i++) {
            double off = numbers[first + i * stride] - numbers[first] - i * step;
            even = Math.abs(off) <= ROUNDING * Math.abs(step);
        }
        return even;
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
        double metersX = LengthUnit.meters(unitX).orElse(1.0);
        double metersY =
                axes.flatMap(matcher -> LengthUnit.meters(matcher.group(2))).orElse(1.0);
        Samples samples = new Samples(
                grid.axisX().count(), grid.axisY().count(), () -> grid.heights().clone());
        Extent extent =
                Extent.ofPitches(grid.axisX().pitch(), grid.axisY().pitch() * metersY / metersX, unitX, samples);
        return Optional.of(new ScanChannel(
                "z", samples, extent, axes.map(matcher -> matcher.group(3)).orElse("")));
    }
}
