package sunbeam.precompute.scan.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PointGridTest {
    private static final int COLUMNS = 37;
    private static final int ROWS = 23;
    private static final double PITCH = 80;

    /** Cells of the grid in random order. */
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
            assertThat(grid.axisY().count()).isEqualTo(ROWS);
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
        TextReader.PointGrid grid = grid(cells, 1e-3);
        assertThat(grid.axisX().count()).isEqualTo(COLUMNS);
        assertThat(grid.axisY().count()).isEqualTo(ROWS);
        for (int cell = 0; cell < COLUMNS * ROWS; cell++) {
            double expected = cells.contains(cell) ? cell : Double.NaN;
            assertThat(grid.heights()[cell]).isEqualTo(Double.valueOf(expected));
        }
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
