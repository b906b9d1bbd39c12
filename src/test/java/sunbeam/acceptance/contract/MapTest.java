package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.CsvFile;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.InOneWorkplace;
import sunbeam.acceptance.NpyImage;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

/** Shape of linear maps, and their values compared with direct sums over the surface. */
class MapTest extends InOneWorkplace {
    private static final double THETA_I = 20;

    /** Makes a rough surface, which scatters in all directions. */
    @BeforeAll
    static void layOut() throws Exception {
        SplittableRandom random = new SplittableRandom(11);
        Images.gray(workplace.resolve("rough.png"), 40, 32, (column, row) -> random.nextInt(256));
    }

    private static NpyImage map(String patch, int side, String options) throws Exception {
        workplace.succeedHere(
                "brdf-map --force --output map.png --linear map.npy --patch %s --size %s " + options, patch, side);
        return NpyImage.read(workplace.resolve("map.npy"), side);
    }

    @ParameterizedTest
    @CsvSource({"full, coherent", "full, ensemble", "table, coherent", "table, ensemble"})
    void colorsAreTheReferencesWithinTheTolerance(String method, String average) throws Exception {
        double tolerance = 1e-2;
        String surface = "--periodic --width 4um --max-height 150nm --coherence-length 8um --average " + average;

        NpyImage drawn = map(
                "rough.png",
                9,
                surface + " --theta-i " + THETA_I + " --method " + method + " --tolerance " + tolerance);

        List<double[]> directions = new ArrayList<>();
        List<double[]> colors = new ArrayList<>();
        for (int row = 0; row < drawn.side(); row++) {
            for (int column = 0; column < drawn.side(); column++) {
                if (drawn.inDisc(row, column)) {
                    double x = drawn.place(column);
                    double y = -drawn.place(row);
                    directions.add(new double[] {
                        THETA_I, 0, Math.toDegrees(Math.asin(Math.hypot(x, y))), Math.toDegrees(Math.atan2(y, x))
                    });
                    colors.add(drawn.xyz(row, column));
                }
            }
        }
        CsvFile exact =
                workplace.reflectance("rough.png", CsvFile.ofDirections(directions), "--method reference " + surface);
        ErrorStatistics errors = Comparison.relative(IntStream.range(0, colors.size())
                .mapToObj(i -> new Comparison(colors.get(i), exact.radiance(i), 1))
                .toList());
        assertThat(errors.count()).as("pixels with light").isGreaterThan(20);
        assertThat(errors.keep(tolerance)).as("%s", errors).isTrue();
    }

    @Test
    void theLinearMapHasItsDocumentedShapeAndNoNumbersOutsideTheDisc() throws Exception {
        int side = 33;

        NpyImage map = map("blaze", side, "--no-annotate");

        assertThat(map.header()).contains("'descr': '<f4'", "'fortran_order': False", "'shape': (33, 33, 3)");
        assertThat(map.values()).hasSize(side * side * 3);
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                for (int channel = 0; channel < 3; channel++) {
                    float value = map.at(row, column, channel);
                    assertThat(Float.isFinite(value))
                            .as("row %d, column %d: %s", row, column, value)
                            .isEqualTo(map.inDisc(row, column));
                    assertThat(value < 0).isFalse();
                }
            }
        }
    }
}
