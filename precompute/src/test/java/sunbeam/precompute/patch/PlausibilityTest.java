package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.HeightMap;

class PlausibilityTest {
    @Test
    void isSilentUpToAQuarterOfTheShortestWavelength() {
        assertThat(Plausibility.pitch(map(2, 2, 95e-9, 95e-9))).isEmpty();
        // 95 nm that come out of a division.
        assertThat(Plausibility.pitch(map(3, 3, 3 * 95e-9 / 3, 95.00000000001e-9)))
                .isEmpty();
    }

    @Test
    void namesAPitchThatIsTooCoarseAndItsAxis() {
        assertThat(Plausibility.pitch(map(2, 2, 120e-9, 50e-9)).orElseThrow())
                .contains("too coarse", "120 nm", "along x", "95 nm", "380 nm");
        assertThat(Plausibility.pitch(map(2, 2, 50e-9, 96e-9)).orElseThrow()).contains("96 nm", "along y");
    }

    @Test
    void doesNotJudgeAnAxisWithASingleSample() {
        assertThat(Plausibility.pitch(map(4, 1, 50e-9, 1e-6))).isEmpty();
        assertThat(Plausibility.pitch(map(1, 4, 1e-6, 50e-9))).isEmpty();
    }

    @Test
    void warnsOfGrayLevelsThatAreHighSteps() {
        assertThat(Plausibility.heightStep(818.69e-9 / 255)).isEmpty();
        assertThat(Plausibility.heightStep(5e-6 / 255).orElseThrow()).contains("19.6078 nm", "16-bit");
    }

    /** More equal samples than a flat mirror needs. */
    @Test
    void refusesALargeFileWithoutAnyHeight() {
        HeightMap empty = map(2049, 2049, 50e-9, 50e-9);
        assertThatThrownBy(() -> Plausibility.requireRelief(empty, Optional.empty(), Path.of("sparse.tif")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("sparse.tif: all of its 2049 x 2049 samples are equal: it is empty")
                .hasMessageContaining("export the scan again");
        empty.heights()[7] = 1e-9;
        HeightMap scan = empty.with(empty.heights());
        assertThatCode(() -> Plausibility.requireRelief(scan, Optional.empty(), Path.of("scan.tif")))
                .doesNotThrowAnyException();
    }

    private static HeightMap map(int columns, int rows, double pitchX, double pitchY) {
        return new HeightMap(columns, rows, pitchX, pitchY, new double[columns * rows]);
    }
}
