package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

class FourierTableTest {
    @ParameterizedTest
    @CsvSource({
        "12, 10, 5, 0",
        "16, 8, 4, 0",
        "1, 13, 3, 0",
        "13, 1, 2, 0",
        "11, 9, 1, 0",
        "12, 10, 5, 40e-9",
        "16, 8, 4, 20e-9"
    })
    void everyTermIsTheDftOfItsPolynomial(int columns, int rows, int terms, double step) {
        HeightMap random = Surfaces.random(columns, rows, 40e-9, 300e-9, columns);
        HeightMap map = step == 0 ? random : rounded(random, step);
        HeightLevels heights = HeightLevels.of(map);
        // Functions of the height are evaluated at samples or at levels.
        assertThat(heights.areTooManyToTabulate()).isEqualTo(step == 0);
        TaylorExpansion expansion = new TaylorExpansion(HeightScale.mean(heights), terms, 5);
        Band bandX = Band.of(-2, 4);
        Band bandY = Band.of(-3, 1);
        FourierTable table = FourierTable.of(heights, expansion, bandX, bandY, done -> {});
        for (int n = 0; n < terms; n++) {
            for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
                for (int jx = bandX.first(); jx <= bandX.last(); jx++) {
                    double[] expected = bin(map, expansion, n, jx, jy);
                    int at = (jy - bandY.first()) * bandX.count() + jx - bandX.first();
                    // Values of at most 1 rounded to float32: half a unit in the last place is 6e-8.
                    assertThat(table.real()[n][at]).isCloseTo((float) expected[0], within(1e-7f));
                    assertThat(table.imaginary()[n][at]).isCloseTo((float) expected[1], within(1e-7f));
                }
            }
        }
    }

    private static HeightMap rounded(HeightMap map, double step) {
        return map.map(height -> step * Math.rint(height / step));
    }

    private static double[] bin(HeightMap map, TaylorExpansion expansion, int n, int jx, int jy) {
        double real = 0;
        double imaginary = 0;
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                double angle = 2 * Math.PI * ((double) jx * column / map.columns() - (double) jy * row / map.rows());
                double value = Math.pow(expansion.scale().scaled(map.at(column, row)), n);
                real += value * Math.cos(angle);
                imaginary += value * Math.sin(angle);
            }
        }
        double samples = (double) map.columns() * map.rows();
        return new double[] {real / samples, imaginary / samples};
    }
}
