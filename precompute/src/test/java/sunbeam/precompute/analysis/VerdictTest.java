package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchFault;
import sunbeam.precompute.patch.builtin.BuiltInPatches;

class VerdictTest {
    private static Patch piece(HeightMap map, List<PatchFault> faults) {
        return new Patch(
                "piece",
                map,
                map,
                "a test",
                List.of(),
                List.of(),
                List.of(),
                faults,
                Optional.empty(),
                Patch.Repetition.NONE);
    }

    private static String verdict(Patch patch) {
        return Verdict.of(patch, GratingPeriod.of(patch));
    }

    /** sin theta = lambda / d, of 400 and 700 nm: 19.5 and 35.7 degrees for 1.2 um. */
    @Test
    void aGratingHasItsIntervalAndItsAngles() {
        HeightMap map = Surfaces.of(150, 150, 100e-9, (x, y) -> 50e-9 * Math.sin(2 * Math.PI * y / 1.2e-6));
        assertThat(verdict(piece(map, List.of())))
                .matches("A grating of 1\\.20* um \\(1\\.(19|20)[0-9]* to 1\\.20[0-9]*\\) across 90 degrees:"
                        + " first-order colors at 19 to 36 degrees under light from above");
    }

    @Test
    void aPeriodBelowAWavelengthHasNoColorFromAbove() {
        HeightMap map = Surfaces.of(150, 150, 20e-9, (x, y) -> 50e-9 * Math.sin(2 * Math.PI * x / 0.3e-6));
        assertThat(verdict(piece(map, List.of()))).endsWith("light from above has no first-order colors");
    }

    @Test
    void flatNoisyAndUnmeasuredSurfacesHaveTheirSentences() {
        HeightMap flat = Surfaces.of(50, 50, 100e-9, (x, y) -> 0);
        assertThat(verdict(piece(flat, List.of()))).startsWith("A mirror: ");
        assertThat(verdict(piece(PeriodlessSurface.WHITE.draw(3), List.of())))
                .startsWith("No order found: a white gloss without color");
        HeightMap lines = Surfaces.of(150, 150, 100e-9, (x, y) -> 50e-9 * Math.sin(2 * Math.PI * x / 1.2e-6));
        PatchFault stopped = new PatchFault("rows 1 to 9 repeat", "--crop", 0.06);
        assertThat(verdict(piece(lines, List.of(stopped))))
                .isEqualTo("No period is told of a scan of which rows 1 to 9 repeat; --crop");
    }

    @Test
    void builtInPatchesHaveTheirs() {
        assertThat(verdict(new Patch("blaze", BuiltInPatches.generate("blaze"), "built in", List.of())))
                .isEqualTo("A repeated patch with a period of 2.5 um across 0 degrees: first-order colors at 9 to 16"
                        + " degrees under light from above");
    }
}
