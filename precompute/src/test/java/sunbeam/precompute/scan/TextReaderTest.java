package sunbeam.precompute.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TextReaderTest {
    private static final int SIDE = 16;

    @TempDir
    private Path folder;

    private double[] read(String text) throws IOException {
        return read(text, Optional.empty());
    }

    /** Of a matrix of two rows or more. */
    private double[] read(String text, Optional<TextReader.DecimalMark> mark) throws IOException {
        return channel(text.getBytes(StandardCharsets.UTF_8), mark).samples().read();
    }

    private ScanChannel channel(byte[] text, Optional<TextReader.DecimalMark> mark) throws IOException {
        try (ScanBytes file = ScanBytes.open(Files.write(folder.resolve("scan.txt"), text))) {
            return TextReader.channels(TextFile.of(file, mark).orElseThrow()).get(0);
        }
    }

    private static String matrix(int rows, int columns, IntBinaryOperator ofRowAndColumn) {
        return IntStream.range(0, rows * columns)
                .mapToObj(i ->
                        ofRowAndColumn.applyAsInt(i / columns, i % columns) + ((i + 1) % columns == 0 ? "\n" : "\t"))
                .collect(Collectors.joining());
    }

    private static int height(int row, int column) {
        return (int) (400 * Math.sin(0.9 * column + 0.1 * row));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1,5 -2,25\n3 4,75\n",
                "1.5 \u22122.25\n3 4.75\n",
                "1.5D+00 -2.25d0\n0.3D+01 47.5D\u221201\n",
                "1,5;-2,25\n3;4,75\n",
                "1,5, -2,25\n3, 4,75\n",
                "1,5, -2,25,\n3, 4,75,\n",
                "1,5,\t-2,25\r\n3,\t4,75\r\n",
                "1.5,-2.25\n3,4.75\n",
                "1.5, -2.25\n3, 4.75\n"
            })
    void fourNumbersAreReadHoweverTheyAreWritten(String text) throws IOException {
        assertThat(read(text)).containsExactly(1.5, -2.25, 3, 4.75);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1,-5,-2,25\n3,0,4,75\n", "1, -5, -2, 25\n3, 0, 4, 75\n"})
    void commasBetweenWholeNumbersSeparateThem(String text) throws IOException {
        assertThat(read(text)).containsExactly(1, -5, -2, 25, 3, 0, 4, 75);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1,5,2,5\n3,5,4,5\n",
                "1,5,-2,25\n3,0,4,75\n",
                "1,25,-12,50,\n13,75,4,00,\n",
                "\"1,5\",\"2,5\"\n\"3,5\",\"4,5\"\n",
                "12,20,13,05\n14,30,15,00\n",
                "1.002,5\t1.003,5\n1.004,5\t1.005,5\n"
            })
    void commasThatMayBeMarksAndSeparatorsNeedADecimalMark(String text) {
        assertThatThrownBy(() -> read(text)).isInstanceOf(UnknownMark.class);
    }

    /** Of a smooth surface from 100.0 to 999.9, with as many decimals as stated; whole numbers of the same range have columns of their own. */
    @Test
    void decimalsAreToldFromWholeNumbersOfManySamples() throws IOException {
        IntToDoubleFunction heights = i -> 550 + 449 * Math.sin(0.37 * i);
        for (String form : List.of("%.1f", "%.2f", "%.3f", "%s")) {
            String text = lines(form, heights).replace('.', ',');
            assertThatThrownBy(() -> read(text)).as(form).isInstanceOf(UnknownMark.class);
        }
        assertThat(read(lines("%.0f", heights))).hasSize(SIDE * SIDE);
        assertThat(read(lines("%.0f", i -> 4000 * heights.applyAsDouble(i)))).hasSize(SIDE * SIDE);
        // Counts of one to three digits.
        assertThat(read(lines("%.0f", i -> 128 + 127 * Math.sin(0.37 * i)))).hasSize(SIDE * SIDE);
    }

    private static String lines(String form, IntToDoubleFunction height) {
        return IntStream.range(0, SIDE * SIDE)
                .mapToObj(i ->
                        String.format(Locale.ROOT, form, height.applyAsDouble(i)) + ((i + 1) % SIDE == 0 ? "\n" : ","))
                .collect(Collectors.joining());
    }

    @Test
    void chosenDecimalMarksDecide() throws IOException {
        assertThat(read("1,5 2,5\n3,5 4,5\n", Optional.of(TextReader.DecimalMark.POINT)))
                .containsExactly(1, 5, 2, 5, 3, 5, 4, 5);
        assertThat(read("1,5\n2,5\n", Optional.of(TextReader.DecimalMark.COMMA)))
                .containsExactly(1.5, 2.5);
        assertThatThrownBy(() -> read("1 2\n3 4,x\n"))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("\"x\" in line 2")
                .hasMessageContaining("say which mark");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-27,357,-41,693", "-2.735,7"})
    void aWordThatIsNoNumberIsQuotedAsItStands(String word) {
        assertThatThrownBy(() -> read(word + ";1\n2;3\n", Optional.of(TextReader.DecimalMark.COMMA)))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining('"' + word + "\" in line 1")
                .hasMessageContaining("semicolons between them and no thousands separators")
                .hasMessageNotContaining("which mark");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "2,024.528;2,038.681\n2,051.516;2,062.597\n",
                "2.024,528;2.038,681\n",
                "24.528\t938.681\n2,051.516\t2,062.597\n"
            })
    void thousandsSeparatorsNeedADecimalMark(String text) throws IOException {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(UnknownMark.class)
                .hasMessageContaining("commas and points in a line");
        // Aligned columns.
        assertThat(read("  1.5, 22.5,111.5\n 11.5,222.5,  1.5\n")).hasSize(6);
    }

    @Test
    void theGridsOwnMarkIsMissing() throws IOException {
        assertThat(read("ncols 2\nnrows 2\ncellsize 0.05\nNODATA_value  -9999\n1 -9999.000\n3 4\n"))
                .containsExactly(1, Double.NaN, 3, 4);
        // ESRI's default.
        assertThat(read("ncols 2\nnrows 2\ncellsize 0.05\n1 -9999\n3 4\n")).containsExactly(1, Double.NaN, 3, 4);
        assertThat(read("ncols 2\nnrows 2\ncellsize 0.05\nNODATA_value 3\n1 -9999\n3 4\n"))
                .containsExactly(1, -9999, Double.NaN, 4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"x [um];y [um];z [nm]", "X (\u00b5m)\tY (\u00b5m)\tHeight (nm)", "x_um,y_um,z_nm"})
    void pointsHaveTheUnitsOfTheirHeader(String header) throws IOException {
        String points = IntStream.range(0, SIDE)
                .mapToObj(i -> i % 4 + "\t" + i / 4 + "\t" + i * i + "\n")
                .collect(Collectors.joining());
        String text = header + "\n" + points;
        ScanChannel channel = channel(text.getBytes(StandardCharsets.UTF_8), Optional.empty());
        assertThat(channel.unit()).isEqualTo("nm");
        // Rounding of the unit's factor.
        assertThat(channel.extent().width().orElseThrow()).isCloseTo(4e-6, within(1e-20));
    }

    @Test
    void emptyFieldsAreMissingSamples() throws IOException {
        assertThat(read("1;2;3\n4;;6\n7; ;9\n10;nan;12\n"))
                .containsExactly(1, 2, 3, 4, Double.NaN, 6, 7, Double.NaN, 9, 10, Double.NaN, 12);
    }

    @Test
    void numbersOfRowsAndPlacesAreNoHeights() {
        assertCounting("column", (row, column) -> column == 0 ? row : height(row, column));
        assertCounting("row", (row, column) -> row == 0 ? column : height(row, column));
        // Rounded, descending, with a word in the corner.
        IntBinaryOperator descending = (row, column) -> row == 0 ? 9 * column : (int) (7.8 * (SIDE - row));
        assertCounting(
                "column",
                (row, column) -> row * column == 0 ? descending.applyAsInt(row, column) : height(row, column));
    }

    private void assertCounting(String line, IntBinaryOperator numbers) {
        assertThatThrownBy(() -> read(matrix(SIDE, SIDE, numbers)))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("first " + line + " that counts");
    }

    private ScanChannel channel(String text) throws IOException {
        return channel(text.getBytes(StandardCharsets.UTF_8), Optional.empty());
    }

    @ParameterizedTest
    @CsvSource({
        "'', 1, -1",
        "'x [um]\tz [nm]\n', 1, 1",
        "'Distance (um), Height (nm)\n', -1, 1",
        "'distance_um;height_nm\n', 1, 1"
    })
    void aProfileIsASurfaceThatIsConstantAlongY(String header, int direction, int known) throws IOException {
        String rows = IntStream.range(0, 40)
                .mapToObj(i -> direction * 0.05 * i + "\t" + height(0, i) + "\n")
                .collect(Collectors.joining());
        ScanChannel profile = channel(header.translateEscapes() + rows);

        assertThat(profile.name()).isEqualTo(ScanChannel.PROFILE);
        assertThat(profile.columns()).isEqualTo(40);
        assertThat(profile.rows()).isEqualTo(40);
        assertThat(profile.unit()).isEqualTo(known > 0 ? "nm" : "");
        assertThat(profile.extent().aspect()).isEqualTo(1);
        assertThat(profile.extent().width().isPresent()).isEqualTo(known > 0);
        profile.extent().width().ifPresent(width -> assertThat(width).isCloseTo(2e-6, within(1e-18)));
        double[] samples = profile.samples().read();
        for (int i = 0; i < samples.length; i++) {
            int place = direction > 0 ? i % 40 : 39 - i % 40;
            assertThat(samples[i]).isEqualTo(height(0, place));
        }
    }

    @Test
    void twoColumnsWithoutEvenPlacesAreNoProfile() {
        assertThatThrownBy(() -> read(matrix(20, 2, (row, column) -> column == 0 ? row * row : height(row, 3))))
                .hasMessageContaining("no evenly spaced places");
    }

    /** ESRI's dx and dy, which may have no unit; twice the pitch along x. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "ncols 3\nnrows 2\nxllcorner 0\ndx 0.2\ndy 0.1\nNODATA_value -9999\n",
                "# x pixel size: 0.2\n# y pixel size: 0.1\n",
                "dx = 200 nm\ndy = 0.1 um\n",
                "pixel width=0.2\npixel height=0.1\nlength unit=um\n"
            })
    void pixelsNeedNotBeSquare(String header) throws IOException {
        ScanChannel channel = channel(header + "1 2 3\n4 5 6\n");
        double ratio = channel.extent()
                .height()
                .map(height -> height / 2 / (channel.extent().width().orElseThrow() / 3))
                .orElse(channel.extent().aspect());

        assertThat(ratio).isCloseTo(0.5, within(1e-12));
        boolean known = header.contains("um");
        assertThat(channel.extent().width().isPresent()).isEqualTo(known);
    }

    @Test
    void aHologramsPhaseHasItsFactor() throws IOException {
        ScanChannel channel = channel("""
                h=2 w=3
                pixel size=3.7e-007 m
                data unit=rad
                height conversion factor (-> m)=6.3e-008
                1 2 3
                4 5 6
                """);

        assertThat(channel.unit()).isEqualTo("m");
        assertThat(channel.extent().width().orElseThrow()).isCloseTo(3 * 3.7e-7, within(1e-18));
        assertThat(channel.samples().read()[5]).isCloseTo(6 * 6.3e-8, within(1e-18));
        assertThatThrownBy(() -> channel("h=3 w=3\npixel size=1 um\n1 2 3\n4 5 6\n"))
                .hasMessageContaining("announces 3 x 3");
    }

    @Test
    void rampsAndWavesAreHeights() throws IOException {
        assertThat(read(matrix(SIDE, SIDE, (row, column) -> 3 * row + 2 * column)))
                .hasSize(SIDE * SIDE);
        assertThat(read(matrix(SIDE, SIDE, TextReaderTest::height))).hasSize(SIDE * SIDE);
        assertThat(read(matrix(SIDE, SIDE, (row, column) -> 7))).hasSize(SIDE * SIDE);
    }

    /** UTF-16. */
    @ParameterizedTest
    @CsvSource({"UTF-16LE, true", "UTF-16BE, true", "UTF-8, true", "UTF-8, false"})
    void wideCharactersAreReadAsOthers(String charset, boolean marked) throws IOException {
        String text = """
                # Channel: H\u00f6he
                # Width: 5 \u03bcm
                # Height: 2,5 \u00b5m
                # Value units: nm
                1,5\t2,5\t-3
                4,25\t5\t6
                """.replace("\n", "\r\n");
        byte[] content = ((marked ? "\ufeff" : "") + text).getBytes(Charset.forName(charset));
        ScanChannel channel = channel(content, Optional.empty());
        assertThat(channel.columns()).isEqualTo(3);
        // Rounding of the unit's factor.
        assertThat(channel.extent().width().orElseThrow()).isCloseTo(5e-6, within(1e-20));
        assertThat(channel.unit()).isEqualTo("nm");
        assertThat(channel.samples().read()).containsExactly(1.5, 2.5, -3, 4.25, 5, 6);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 7})
    void halfACharacterIsNoNumber(int length) throws IOException {
        Path path = folder.resolve("scan.txt");
        Files.write(path, Arrays.copyOf("\ufeff1\t2".getBytes(StandardCharsets.UTF_16LE), length));
        try (ScanBytes bytes = ScanBytes.open(path)) {
            assertThat(TextFile.of(bytes, Optional.empty())).isEmpty();
        }
    }

    private static final int COLUMNS = 37;
    private static final int ROWS = 23;
    private static final double PITCH = 80;

    private static List<Integer> shuffled() {
        List<Integer> cells = IntStream.range(0, COLUMNS * ROWS).boxed().collect(Collectors.toList());
        Collections.shuffle(cells, new Random(4));
        return cells;
    }

    /** @param digits what coordinates are rounded to */
    private static TextReader.PointGrid grid(List<Integer> cells, double digits) {
        double[][] points = new double[3][cells.size()];
        for (int i = 0; i < cells.size(); i++) {
            int cell = cells.get(i);
            points[0][i] = Math.rint((cell % COLUMNS + 0.5) * PITCH / digits) * digits;
            points[1][i] = Math.rint((ROWS - cell / COLUMNS - 0.5) * PITCH / digits) * digits;
            points[2][i] = cell;
        }
        return TextReader.PointGrid.of(points[0], points[1], points[2]).orElseThrow();
    }

    @Test
    void pointsMayComeInAnyOrder() {
        // Rounded to 3 nm: two of three columns are off by 1 nm, a fortieth of their distance.
        for (double digits : new double[] {1e-3, 3}) {
            TextReader.PointGrid grid = grid(shuffled(), digits);
            assertThat(grid.axisX().count()).isEqualTo(COLUMNS);
            // The first and last of 37 columns are off by the rounding.
            assertThat(grid.axisX().pitch()).isCloseTo(PITCH, within(digits / (COLUMNS - 1)));
            assertThat(grid.heights())
                    .containsExactly(
                            IntStream.range(0, COLUMNS * ROWS).asDoubleStream().toArray());
        }
    }

    @Test
    void cellsWithoutPointsAreMissingSamples() {
        List<Integer> cells = shuffled();
        cells.removeIf(cell -> cell % 5 == 0);
        assertThat(grid(cells, 1e-3).heights())
                .containsExactly(IntStream.range(0, COLUMNS * ROWS)
                        .mapToDouble(cell -> cell % 5 == 0 ? Double.NaN : cell)
                        .toArray());
    }

    @Test
    void pointsWithoutGridAreNone() {
        Random random = new Random(9);
        double[] x = random.doubles(400).toArray();
        double[] y = random.doubles(400).toArray();
        assertThat(TextReader.PointGrid.of(x, y, x)).isEmpty();
        // On a line.
        assertThat(TextReader.PointGrid.of(new double[400], y, x)).isEmpty();
        x[7] = Double.NaN;
        assertThat(TextReader.PointGrid.of(x, y, y)).isEmpty();
    }
}
