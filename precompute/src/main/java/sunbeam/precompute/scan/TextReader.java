package sunbeam.precompute.scan;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;

/** Reader of text: after any header, a matrix of numbers from the top row, or points x y z on a grid. */
public final class TextReader {
    /** Mark of decimals that the user chose; with a point, commas separate numbers. */
    public enum DecimalMark {
        POINT,
        COMMA
    }

    private static final int PROFILE = 2;
    /** Samples of the surface of a profile, about: a square one of 1024 x 1024, fewer rows of a longer profile. */
    private static final int PROFILE_SAMPLES = 1 << 20;

    private static final Pattern TWO_AXES =
            Pattern.compile("[^\\[(]{0,60}[\\[(]([^\\])]*)[\\])][^\\[(]{0,60}[\\[(]([^\\])]*)[\\])][^\\[(]{0,60}");
    private static final int POINT = 3;
    // Lines from which on three numbers each must be points, no matrix.
    private static final int SURELY_POINTS = 16;
    // Evenly spaced numbers from which on they count as coordinates.
    private static final int FEWEST_EVENLY_SPACED = 8;
    // Share of the step; files round numbers.
    private static final double ROUNDING = 0.2;

    private static final Pattern AXES = Pattern.compile(
            "(?i)[#%;*\\s\"]*x\\s*[\\[(]([^\\])]+)[\\])]\\W+y\\s*[\\[(]([^\\])]+)[\\])]\\W+(?:z|height)\\s*[\\[(]([^\\])]+)[\\])].*");

    // A name and its unit, such as "x_mm".
    private static final Pattern UNDERSCORED = Pattern.compile("(?<![\\w.])([A-Za-z]{1,20})_([^\\s,;\"_\\[(]{1,12})");

    private TextReader() {}

    /** Writes units of length after an underscore in brackets: "x_mm" as "x [mm]". */
    private static String bracketed(String line) {
        return UNDERSCORED
                .matcher(line)
                .replaceAll(name -> Matcher.quoteReplacement(
                        Extent.metersPer(name.group(2)).isPresent()
                                ? name.group(1) + " [" + name.group(2) + "]"
                                : name.group()));
    }

    static List<ScanChannel> channels(TextFile text) throws IOException {
        TextFile.Facts facts = TextFile.Facts.of(text.header());
        TextNumbers numbers = text.numbers();
        boolean list = !facts.areOfMatrix() && numbers.ragged.isEmpty();
        if (list && numbers.columns == PROFILE && numbers.rows > 2) {
            return List.of(profile(text, facts, numbers));
        }
        boolean three = list && numbers.columns == POINT && numbers.rows > POINT;
        Optional<ScanChannel> points = three ? points(text, numbers) : Optional.empty();
        return List.of(points.orElseGet(() -> matrix(facts, numbers, text.missing())));
    }

    /** Returns heights beside evenly spaced places as a surface that is constant along y. */
    private static ScanChannel profile(TextFile text, TextFile.Facts facts, TextNumbers numbers) {
        double[] places = numbers.column(0);
        ScanException.refuseIf(
                !isEvenlySpaced(places, 0, 1, places.length),
                "has two columns, of which the first has no evenly spaced places: it is no profile of "
                        + FEWEST_EVENLY_SPACED + " heights or more; interpolate them, or export the whole image");
        Matcher axes = text.header().stream()
                .map(TextReader::bracketed)
                .map(TWO_AXES::matcher)
                .filter(Matcher::matches)
                .findFirst()
                .orElseGet(() -> TWO_AXES.matcher("[] []"));
        boolean named = axes.matches();
        int columns = places.length;
        double step = (places[columns - 1] - places[0]) / (columns - 1);
        Samples samples = new Samples(columns, Math.min(columns, Math.max(2, PROFILE_SAMPLES / columns)), () -> {
            double[] heights = numbers.column(1);
            double[] all = new double[columns * Math.min(columns, Math.max(2, PROFILE_SAMPLES / columns))];
            Arrays.setAll(all, i -> heights[i % columns]);
            return all;
        });
        Samples upwards = step < 0 ? samples.flipColumns() : samples;
        Extent extent = Extent.ofPitches(Math.abs(step), Math.abs(step), named ? axes.group(1) : "", samples);
        String unit = named ? axes.group(2) : "";
        return new ScanChannel(
                ScanChannel.PROFILE, upwards.withMissing(text.missing()), extent, unit.isEmpty() ? facts.unit() : unit);
    }

    private static ScanChannel matrix(TextFile.Facts facts, TextNumbers numbers, double missing) {
        ScanException.refuseIf(
                facts.columns().isEmpty() && !numbers.ragged.isEmpty(),
                "has " + numbers.ragged + ", but " + numbers.columns + " in its first row; export it again");
        int columns = facts.columns().orElse(numbers.columns);
        boolean announced = facts.columns().isPresent() && facts.rows().isPresent();
        int rows = announced ? facts.rows().get() : numbers.count / columns;
        ScanException.refuseIf(
                (long) columns * rows != numbers.count,
                "has " + numbers.count + " numbers where its header announces " + columns + " x " + rows
                        + "; export it again");
        Samples samples = new Samples(columns, rows, () -> {
            double[] heights = numbers.first(numbers.count);
            refuseCoordinates(heights, columns, rows);
            return heights;
        });
        Samples heights = samples.withMissing(missing).scale(facts.factor(), 0);
        return new ScanChannel(facts.channel(), heights, facts.extent(samples), facts.unit());
    }

    /** Refuses a first column or row of coordinates or row numbers. */
    private static void refuseCoordinates(double[] heights, int columns, int rows) {
        // The corner, where the first column and row meet, is left out.
        boolean column = columns > 1
                && isEvenlySpaced(heights, columns, columns, rows - 1)
                && !isEvenlySpaced(heights, columns + 1, columns, rows - 1);
        boolean row = rows > 1
                && isEvenlySpaced(heights, 1, 1, columns - 1)
                && !isEvenlySpaced(heights, columns + 1, 1, columns - 1);
        ScanException.refuseIf(
                column || row,
                "has a first " + (column ? "column" : "row") + " that counts evenly, as places or numbers of rows do,"
                        + " beside others that do not; remove it, so that only heights are left");
    }

    private static boolean isEvenlySpaced(double[] numbers, int first, int stride, int count) {
        int last = first + (count - 1) * stride;
        if (count < FEWEST_EVENLY_SPACED || last >= numbers.length) {
            return false;
        }
        double step = (numbers[last] - numbers[first]) / (count - 1);
        return Math.abs(step) > 0
                && IntStream.range(0, count)
                        .mapToDouble(i -> numbers[first + i * stride] - numbers[first] - i * step)
                        .allMatch(off -> Math.abs(off) <= ROUNDING * Math.abs(step));
    }

    private static Optional<ScanChannel> points(TextFile text, TextNumbers numbers) {
        Optional<PointGrid> found = PointGrid.of(numbers.column(0), numbers.column(1), numbers.column(2));
        ScanException.refuseIf(
                found.isEmpty() && numbers.rows >= SURELY_POINTS,
                "has three numbers a line whose first two are no points of a grid; interpolate the points in Gwyddion and"
                        + " export a matrix or .gwy");
        return found.map(grid -> points(text, grid));
    }

    private static ScanChannel points(TextFile text, PointGrid grid) {
        // Units of x, y and z.
        String[] units = text.header().stream()
                .map(TextReader::bracketed)
                .map(AXES::matcher)
                .filter(Matcher::matches)
                .findFirst()
                .map(axes -> new String[] {axes.group(1), axes.group(2), axes.group(3)})
                .orElse(new String[] {"", "", ""});
        double metersX = Extent.metersPer(units[0]).orElse(1.0);
        double pitchY = grid.axisY.pitch * Extent.metersPer(units[1]).orElse(1.0) / metersX;
        Samples samples = new Samples(grid.axisX.count, grid.axisY.count, grid.heights::clone);
        return new ScanChannel("z", samples, Extent.ofPitches(grid.axisX.pitch, pitchY, units[0], samples), units[2]);
    }

    /** Grid of points x y z, listed in any order: heights row by row from the largest y, NaN without a point. */
    record PointGrid(Axis axisX, Axis axisY, double[] heights) {
        // In pitches. Coordinates closer than twice this share of the largest gap belong to one line; files round them.
        private static final double MOST_OFF = 0.05;
        private static final double MOST_MISSING = 0.5;

        /** Equidistant coordinates in ascending order, in the file's unit. */
        record Axis(double first, double pitch, int count) {
            int index(double coordinate) {
                return (int) Math.round((coordinate - first) / pitch);
            }

            static Optional<Axis> of(double[] coordinates) {
                double[] sorted = coordinates.clone();
                Arrays.sort(sorted);
                double least = sorted[0];
                double range = sorted[sorted.length - 1] - least;
                if (!(range > 0) || !Double.isFinite(range)) {
                    return Optional.empty();
                }
                double largest = 0;
                for (int i = 1; i < sorted.length; i++) {
                    largest = Math.max(largest, sorted[i] - sorted[i - 1]);
                }
                double sameLine = 2 * MOST_OFF * largest;
                int steps = (int) IntStream.range(1, sorted.length)
                        .filter(i -> sorted[i] - sorted[i - 1] > sameLine)
                        .count();
                Axis axis = new Axis(least, range / steps, steps + 1);
                boolean onLines = Arrays.stream(sorted)
                        .map(coordinate -> (coordinate - axis.first) / axis.pitch)
                        .allMatch(position -> Math.abs(position - Math.rint(position)) <= MOST_OFF);
                return onLines ? Optional.of(axis) : Optional.empty();
            }
        }

        /** @throws ScanException if two points share a cell */
        static Optional<PointGrid> of(double[] x, double[] y, double[] z) {
            Optional<Axis> columns = Axis.of(x);
            Optional<Axis> rows = columns.isEmpty() ? Optional.empty() : Axis.of(y);
            if (rows.isEmpty() || (long) columns.get().count * rows.get().count > x.length / MOST_MISSING) {
                return Optional.empty();
            }
            Axis axisX = columns.get();
            Axis axisY = rows.get();
            double[] heights = new double[axisX.count * axisY.count];
            boolean[] taken = new boolean[heights.length];
            Arrays.fill(heights, Double.NaN);
            for (int i = 0; i < x.length; i++) {
                int cell = (axisY.count - 1 - axisY.index(y[i])) * axisX.count + axisX.index(x[i]);
                if (taken[cell]) {
                    throw new ScanException(Text.format(
                            "has two points at x = %s, y = %s; export the scan as a matrix or as .gwy", x[i], y[i]));
                }
                taken[cell] = true;
                heights[cell] = z[i];
            }
            return Optional.of(new PointGrid(axisX, axisY, heights));
        }
    }

    /** Numbers of a text; an empty field is a missing sample. */
    static final class TextNumbers {
        private static final Pattern MISSING =
                Pattern.compile("(?i)[-+]?(nan|nan\\(ind\\)|inf|infinity)|bad|---?|#?n/a");
        private static final int FIRST_CAPACITY = 1 << 12;
        // Three for each point of the largest grid.
        private static final long MOST = 3 * Samples.MOST_SAMPLES;
        private static final int LONGEST_WORD = 100;

        private static final String BLANKS = " \t\"\f\ufeff";

        private final boolean decimalComma;
        private final String remedy;
        private double[] values = new double[FIRST_CAPACITY];
        private int count;
        private int columns;
        private int rows;
        private String ragged = "";

        /** Reads numbers; throws ScanException if there are too many, or, with the remedy, for a word that is no number. */
        TextNumbers(BufferedReader in, boolean decimalComma, String remedy, long line, long most) throws IOException {
            this.decimalComma = decimalComma;
            this.remedy = remedy;
            long number = line;
            for (String text = in.readLine(); text != null && count < most; text = in.readLine()) {
                add(text, number++);
            }
        }

        private void add(String text, long line) {
            int before = count;
            boolean separated = false;
            String separators = decimalComma ? ";" : ";,";
            StringTokenizer tokens = new StringTokenizer(text, separators + BLANKS, true);
            while (tokens.hasMoreTokens()) {
                String token = tokens.nextToken();
                boolean separator = separators.contains(token);
                if (separator && separated) {
                    add(Double.NaN);
                } else if (!separator && !BLANKS.contains(token)) {
                    add(parse(token, line));
                    separated = false;
                }
                separated |= separator;
            }
            int added = count - before;
            rows += added > 0 ? 1 : 0;
            columns = rows == 1 && added > 0 ? added : columns;
            if (added > 0 && added != columns && ragged.isEmpty()) {
                ragged = added + " numbers in line " + line;
            }
        }

        private double parse(String word, long line) {
            // In "1,5, 2,5" the comma after the first number is a separator.
            boolean trailing = decimalComma && word.length() > 1 && word.endsWith(",");
            String text = (trailing ? word.substring(0, word.length() - 1) : word)
                    .replace(',', '.')
                    .replace('\u2212', '-');
            // Double.parseDouble also accepts 1d, 0x1p3 and Infinity. Fortran writes 1.0D+01.
            if (text.length() <= LONGEST_WORD
                    && text.chars().allMatch(c -> (c >= '0' && c <= '9') || "+-.eEdD".indexOf(c) >= 0)) {
                try {
                    return Double.parseDouble(text.replace('d', 'e').replace('D', 'e'));
                } catch (NumberFormatException none) {
                    // Refused below.
                }
            }
            if (MISSING.matcher(text).matches()) {
                return Double.NaN;
            }
            throw new ScanException(
                    "has " + Text.quoted(word) + " in line " + line + ", where a number should be; " + remedy);
        }

        private void add(double value) {
            if (count == values.length) {
                ScanException.refuseIf(
                        count >= MOST, "has more than " + MOST + " numbers, more than can be used; crop the scan");
                Samples.requireMemory(2L * count, 0);
                values = Arrays.copyOf(values, (int) Math.min(MOST, 2L * count));
            }
            values[count++] = value;
        }

        double[] first(int wanted) {
            ScanException.refuseIf(
                    wanted > count,
                    "has " + count + " numbers where its header announces " + wanted + "; copy or export it again");
            return Arrays.copyOf(values, wanted);
        }

        double[] column(int column) {
            double[] some = new double[rows];
            Arrays.setAll(some, row -> values[row * columns + column]);
            return some;
        }
    }
}
