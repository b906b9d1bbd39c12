package sunbeam.precompute.scan.text;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.scan.ScanException;

/** Matrices of which a line is none of heights. */
class CountedLinesTest {
    private static final int SIDE = 16;

    private interface Matrix {
        double at(int row, int column);
    }

    private static double[] matrix(int rows, int columns, Matrix of) {
        double[] all = new double[rows * columns];
        for (int i = 0; i < all.length; i++) {
            all[i] = of.at(i / columns, i % columns);
        }
        return all;
    }

    private static double height(int row, int column) {
        return 40 * Math.sin(0.9 * column + 0.1 * row);
    }

    @Test
    void numbersOfRowsAndPlacesAreNoHeights() {
        double[] numbered = matrix(SIDE, SIDE, (row, column) -> column == 0 ? row : height(row, column));
        // Rounded to two digits, downwards, with something else in the corner.
        double[] places = matrix(
                SIDE,
                SIDE,
                (row, column) -> column == 0 && row > 0
                        ? 0.01 * Math.round(100 * 0.078 * (SIDE - row))
                        : row == 0 ? 0.078 * column : height(row, column));
        double[] above = matrix(SIDE, SIDE, (row, column) -> row == 0 ? 0.1 * column : height(row, column));

        assertThatThrownBy(() -> CountedLines.refuse(numbered, SIDE))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("first column that counts");
        assertThatThrownBy(() -> CountedLines.refuse(places, SIDE)).hasMessageContaining("first column that counts");
        assertThatThrownBy(() -> CountedLines.refuse(above, SIDE)).hasMessageContaining("first row that counts");
    }

    @Test
    void aProfileIsNoScan() {
        double[] profile = matrix(SIDE, 2, (row, column) -> column == 0 ? 0.1 * row : height(row, 3));
        assertThatThrownBy(() -> CountedLines.refuse(profile, 2)).hasMessageContaining("a profile");
    }

    @Test
    void rampsAndWavesAreHeights() {
        assertThatCode(() -> CountedLines.refuse(matrix(SIDE, SIDE, (row, column) -> 3 * row + 2 * column), SIDE))
                .doesNotThrowAnyException();
        assertThatCode(() -> CountedLines.refuse(matrix(SIDE, SIDE, CountedLinesTest::height), SIDE))
                .doesNotThrowAnyException();
        assertThatCode(() -> CountedLines.refuse(matrix(SIDE, SIDE, (row, column) -> 7), SIDE))
                .doesNotThrowAnyException();
    }
}
