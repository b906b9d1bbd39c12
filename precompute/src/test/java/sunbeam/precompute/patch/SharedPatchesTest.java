package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.HeightMap;

/** The measured patches, if shared/ is present. */
class SharedPatchesTest {
    /** Relative to the module's folder, in which tests run. */
    private static final Path PATCHES = Path.of("..", "..", "shared", "patches");

    private static Patch load(String name) {
        Path file = PATCHES.resolve(name + ".json");
        assumeTrue(Files.exists(file), () -> "the measured patches are not there: " + file);
        return PatchRequests.load(file);
    }

    @ParameterizedTest
    @CsvSource({
        // Full scale and the lowest and highest of 255 levels.
        "elaphe, 1332, 65e-6, 375e-9, 0, 255",
        "xenopeltis, 1332, 65e-6, 818.69e-9, 0, 252",
        "blaze, 100, 2.5e-6, 250e-9, 0, 255"
    })
    void haveTheSizesAndHeightsOfTheThesis(
            String name, int side, double width, double fullScale, int lowest, int highest) {
        Patch patch = load(name);
        HeightMap heights = patch.heights();

        assertThat(patch.name()).isEqualTo(name);
        assertThat(heights.columns()).isEqualTo(side);
        assertThat(heights.rows()).isEqualTo(side);
        // One division and one multiplication.
        assertThat(heights.width() / width - 1).isBetween(-3e-16, 3e-16);
        assertThat(heights.pitchY()).isEqualTo(heights.pitchX());
        // A few roundings of heights below 1 um.
        assertThat(heights.relief() - fullScale * (highest - lowest) / 255).isBetween(-1e-21, 1e-21);
    }

    @ParameterizedTest
    @CsvSource({"elaphe, 8.2 %", "xenopeltis, 21.6 %"})
    void snakeSkinsAreSteeperThanScalarTheoryLikesAndDoNotTile(String name, String share) {
        List<String> warnings = load(name).warnings();
        assertThat(warnings).hasSize(2);
        assertThat(warnings.get(0))
                .startsWith("the scan's repetition has a step that draws a cross: opposite borders differ by");
        assertThat(warnings.get(1)).startsWith("slopes too steep for scalar theory: " + share);
    }
}
