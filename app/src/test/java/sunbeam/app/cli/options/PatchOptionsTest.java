package sunbeam.app.cli.options;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

class PatchOptionsTest extends CommandLineFixture {
    /** Writes a grating in text: 40 x 20 samples, 4 um wide, tilted by 39 nm. */
    private Path scan() throws IOException {
        return scan("scan.txt", "", 40, 20, (column, row) -> column + 20 * Math.sin(2 * Math.PI * column / 7.3));
    }

    private static Choices method(String... words) {
        return CommandLine.populateCommand(new MethodOptions(), words).choices();
    }

    private Patch load(Choices method) throws IOException {
        String[] words = {"--patch", scan().toString(), "--width", "4um", "--height-unit", "nm"};
        return CommandLine.populateCommand(new PatchOptions(), words).load(method);
    }

    @Test
    void theThesisTakesAScanThatIsGivenDirectlyAsItIs() throws IOException {
        Choices thesis = method("--preset", "thesis");
        Patch patch = load(thesis);
        // Only the mean is removed, the edges are not blended, and the scan repeats over 65 um.
        assertThat(patch.source()).contains("levelling mean").doesNotContain("blended");
        assertThat(patch.heights().heights()).isEqualTo(patch.scan().heights());
        assertThat(patch.heights().at(39, 0) - patch.heights().at(0, 0))
                .isCloseTo(1e-9 * (39 + 20 * Math.sin(2 * Math.PI * 39 / 7.3)), within(1e-18));
        assertThat(ScanLimit.of(thesis, patch).choices().get(MethodSettings.COHERENCE_LENGTH))
                .isEqualTo(65e-6);
    }

    @Test
    void otherwiseItIsLevelledBlendedAndSeenNoFartherThanItReaches() throws IOException {
        Choices standard = method();
        Patch patch = load(standard);
        assertThat(patch.source()).contains("levelling plane", "edges blended");
        assertThat(ScanLimit.of(standard, patch).choices().get(MethodSettings.COHERENCE_LENGTH))
                .isEqualTo(patch.heights().width());
    }

    /** Three folders have a file of the same name. */
    @Test
    void surfacesOfOneNameAreToldApart() {
        HeightMap heights = new HeightMap(2, 1, 1e-7, 1e-7, new double[] {0, 1e-8});
        Patch first = new Patch("wing", heights, "a/wing.gsf", List.of());
        Patch second = PatchOptions.Compared.distinct(first, List.of(first));
        Patch third = PatchOptions.Compared.distinct(first, List.of(first, second));
        assertThat(second.name()).isEqualTo("wing-2");
        assertThat(second.notes()).anyMatch(note -> note.contains("another surface has the name wing"));
        assertThat(third.name()).isEqualTo("wing-3");
        assertThat(PatchOptions.Compared.distinct(third, List.of(first, second)))
                .isSameAs(third);
    }
}
