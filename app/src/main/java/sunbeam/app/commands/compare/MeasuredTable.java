package sunbeam.app.commands.compare;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.app.files.input.CsvTable;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.InputException;

/**
 * What an instrument such as a goniometer measured in directions: colors, spectra, or values at one wavelength a row. All are
 * proportional to radiance or BRDF, with one factor for the table.
 *
 * @param directions a row each; with wavelengths where the file has them in rows
 * @param nanometers of the columns of a spectrum, ascending; none otherwise
 * @param values of each row: X, Y, Z; the spectrum; or the one value
 */
record MeasuredTable(DirectionList directions, int[] nanometers, List<double[]> values) {
    private static final List<String> XYZ = List.of("X", "Y", "Z");
    private static final String GAIN = "gain";
    private static final String BRDF = "brdf";
    private static final int FIRST = 380;
    private static final int LAST = 780;
    private static final long MOST_BYTES = 64L << 20;
    private static final int MOST_VALUES = 4_000_000;
    // What colors are made of: most of the light of the three functions, in steps that they are smooth in.
    private static final int COLOR_FROM = 420;
    private static final int COLOR_TO = 680;
    private static final int WIDEST_STEP = 20;

    /**
     * Reads a table with the columns of {@link DirectionList}, and X, Y, Z; or brdf; or wavelengths as names of columns.
     *
     * @throws InputException when the file cannot be used
     */
    static MeasuredTable read(Path file) {
        InputException.requireSmall(file, MOST_BYTES, "it has more than 64 MiB; split it");
        List<String> wavelengths =
                IntStream.rangeClosed(FIRST, LAST).mapToObj(Integer::toString).toList();
        List<String> wanted = new ArrayList<>(XYZ);
        wanted.addAll(List.of(GAIN, BRDF));
        wanted.addAll(wavelengths);
        CsvTable table = DirectionList.table(file, wanted);
        List<String> columns = table.columns();
        int[] nanometers = columns.stream()
                .filter(wavelengths::contains)
                .mapToInt(Integer::parseInt)
                .sorted()
                .toArray();
        DirectionList directions = DirectionList.of(table);
        boolean hasColors = columns.containsAll(XYZ);
        boolean hasRows = directions.spectral() && columns.contains(BRDF);
        int kinds = (hasColors ? 1 : 0) + (hasRows ? 1 : 0) + (nanometers.length > 0 ? 1 : 0);
        if (kinds != 1 || (directions.spectral() && !hasRows)) {
            throw new InputException("cannot use " + file
                    + ": beside directions it needs either the columns X,Y,Z, or wavelength,brdf, or a column for each"
                    + " wavelength in nm (380 to 780), and no two of these");
        }
        if ((long) table.rows().size() * Math.max(1, nanometers.length) > MOST_VALUES) {
            throw new InputException("cannot use " + file + ": more than " + MOST_VALUES + " values; split it");
        }
        int[] places =
                names(hasColors, nanometers).stream().mapToInt(columns::indexOf).toArray();
        int gain = hasColors ? columns.indexOf(GAIN) : -1;
        return new MeasuredTable(
                directions,
                nanometers,
                table.rows().stream()
                        .map(row -> IntStream.of(places)
                                .mapToDouble(place -> row[place] * (gain < 0 ? 1 : row[gain]))
                                .toArray())
                        .toList());
    }

    private static List<String> names(boolean ofColors, int[] nanometers) {
        if (ofColors) {
            return XYZ;
        }
        return nanometers.length == 0
                ? List.of(BRDF)
                : IntStream.of(nanometers).mapToObj(Integer::toString).toList();
    }

    /** What the values of a row are called in files. */
    List<String> names() {
        return names(isOfColors(), nanometers);
    }

    /** Whether rows are X, Y, Z. */
    boolean isOfColors() {
        return nanometers.length == 0 && !directions.spectral();
    }

    /** Whether rows have a color, if by their spectra. */
    boolean hasColors() {
        return isOfColors() || spectraHaveColors();
    }

    private boolean spectraHaveColors() {
        int last = nanometers.length - 1;
        return last > 0
                && nanometers[0] <= COLOR_FROM
                && nanometers[last] >= COLOR_TO
                && IntStream.range(0, last).allMatch(i -> nanometers[i + 1] - nanometers[i] <= WIDEST_STEP);
    }

    String describe() {
        if (isOfColors()) {
            return "X, Y, Z";
        }
        return nanometers.length == 0
                ? "BRDF at one wavelength each"
                : "spectra of " + nanometers.length + " wavelengths, " + nanometers[0] + " to "
                        + nanometers[nanometers.length - 1] + " nm";
    }

    /** A row of directions for each value: as many for each row as its spectrum has wavelengths. */
    DirectionList queries() {
        if (nanometers.length == 0) {
            return directions;
        }
        return directions.at(IntStream.of(nanometers).asDoubleStream().toArray());
    }

    /** All values of the table that are compared with one factor: luminances, or what spectra hold. */
    double[] fitted(List<double[]> rows) {
        return rows.stream()
                .flatMapToDouble(row -> isOfColors() ? DoubleStream.of(row[1]) : DoubleStream.of(row))
                .toArray();
    }
}
