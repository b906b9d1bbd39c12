package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;

import io.jhdf.HdfFile;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.patch.HeightLevels;

class TableFileTest {
    @TempDir
    Path folder;

    /** The format of docs/conventions.md. */
    @Test
    void filesDescribeTheirTableCompletely() {
        HeightLevels heights = HeightLevels.of(Surfaces.random(12, 10, 50e-9, 300e-9, 1));
        HeightScale scale = HeightScale.midRange(heights);
        LowRankExpansion expansion = LowRankExpansion.within(heights, scale, 0, 5, 1e-3);
        FourierTable table = FourierTable.of(heights, expansion, Band.of(-2, 3), Band.of(-4, 1), done -> {});
        Path file = folder.resolve("table.h5");

        TableFile.write(file, table, "test patch µ", "digest");

        try (HdfFile hdf = new HdfFile(file)) {
            float[][][][] terms = (float[][][][]) hdf.getDatasetByPath("terms").getData();
            assertThat(terms).hasDimensions(table.terms(), 2);
            for (int n = 0; n < table.terms(); n++) {
                assertThat(terms[n][0][5][0]).isEqualTo(table.real()[n][5 * 6]);
                assertThat(terms[n][1][1][3]).isEqualTo(table.imaginary()[n][6 + 3]);
            }
            float[][] coefficients =
                    (float[][]) hdf.getDatasetByPath("coefficients").getData();
            assertThat(coefficients).hasNumberOfRows(expansion.terms());
            assertThat(coefficients[1][0]).isEqualTo((float) expansion.coefficients(0)[1]);
            assertThat(hdf.getAttribute("patch_name").getData()).isEqualTo("test patch µ");
            assertThat(hdf.getAttribute("pitch_y_metres").getData()).isEqualTo(50e-9);
            assertThat(hdf.getAttribute("first_bin_y").getData()).isEqualTo(-4);
            assertThat(hdf.getAttribute("expansion").getData()).isEqualTo("lowrank");
            assertThat(hdf.getAttribute("height_half_range_metres").getData()).isEqualTo(scale.halfRange());
        }
    }
}
