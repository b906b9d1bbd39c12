package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.PeriodInterpolation;

/** Parses methods, patches, ranges and certificates from command lines. */
class OptionsTest extends CommandLineFixture {
    private static Choices parse(String options) {
        return CommandLine.populateCommand(new MethodOptions(), MethodProbe.words(options))
                .choices();
    }

    private static Method method(String options) {
        return Methods.of(parse(options));
    }

    @Test
    void fullWithinTheStandardToleranceNeedsNoOption() {
        assertThat(method(""))
                .isEqualTo(new FullMethod(
                        TableChoices.within(ErrorBudget.STANDARD), GaussianArea.STANDARD, FresnelFactor.ONCE));
        assertThat(method("--preset thesis")).isEqualTo(FullMethod.thesis());
        assertThat(method("--method FULL --expansion Taylor")).isEqualTo(method("--expansion taylor"));
    }

    @Test
    void aMethodTakesItsOwnOptions() {
        PqMethod pq = (PqMethod) method("--method pq --interpolation linear --replicas 7");
        assertThat(pq.interpolation()).isEqualTo(PeriodInterpolation.LINEAR);
        assertThat(pq.replicas()).hasValue(7);
        assertThat(((GemMethod) method("--method gem --spacing 1.6um")).spacing())
                .hasValue(1.6e-6);
    }

    @Test
    void metadataSayWhatWasChosenAndWhatHoldsBesides() {
        assertThat(Methods.describe(parse("--terms 12")))
                .isEqualTo("tolerance 0.001, terms 12, coherence length 65 um, average coherent");
        assertThat(Methods.describe(parse("--preset thesis --radius 3")))
                .isEqualTo("preset thesis, radius 3, coherence length 65 um, average coherent");
        assertThat(Methods.describe(parse("--method gem --spacing 1.6um")))
                .isEqualTo("spacing 1.6 um, coherence length 65 um");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --tolerance 1.5|--tolerance 1.5 is out of range; give 1e-5 to 1
            --tolerance NaN|--tolerance "NaN" is no number
            --tolerance 1e-6|method reference
            --coherence-length 0m|--coherence-length 0 m is out of range; give 100 nm to 10 mm
            --terms 501|--terms 501 is out of range; give 1 to 500
            --terms 1.5|--terms "1.5" is no whole number
            --radius -1|--radius -1 is out of range; give 0 to 15
            --wavelength-step 300nm|--wavelength-step 300 nm is out of range; give 1 pm to 200 nm
            --method nmm --interpolation sinc|--interpolation sinc belongs to --method pq, not nmm; leave it out
            --radius 1 --method reference|--radius 1 belongs to --method full or nmm, not reference; leave it out
            --replicas 3|--replicas 3 belongs to --method pq or reference, not full; leave it out or use --method pq
            --spacing 1um|--spacing 1 um belongs to --method gem, not full; leave it out or use --method gem
            --method pq --replicas 0|--replicas 0 is out of range; give 1 to 10000
            --method gem --spacing 1nm|--spacing 1 nm is out of range; give 100 nm to 1 mm
            --method gem --spacing 3|--spacing "3" has no unit
            --method pq --average ensemble|--average ensemble is not for --method pq, which has coherent only
            --method reference --replicas 3 --average ensemble|--average ensemble is not for --replicas
            """)
    void whatCannotBeMeantIsRefusedWithTheRemedy(String options, String words) {
        assertThatThrownBy(() -> method(options))
                .isInstanceOfSatisfying(
                        SettingException.class,
                        failure -> assertThat(failure.place()).isEqualTo(ChoiceOrigin.Place.OPTION))
                .hasMessageContaining(words);
    }

    @ParameterizedTest
    @CsvSource({
        "380:780:5, 81, 380, 780",
        "0:0.3:0.1, 4, 0, 0.3",
        "0:10:4, 3, 0, 8",
        "550:550:1, 1, 550, 550",
        "550, 1, 550, 550"
    })
    void aRangeHasBothEndsUnlessTheStepDoesNotMeetTheLast(String text, int count, double first, double last) {
        assertThat(Range.parse(text).values()).hasSize(count).startsWith(first).endsWith(last);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1:2", "1:2:3:4", "a:2:1", "2:1:1", "1:2:0", "1:2:-1", "1:NaN:1", "0:1e9:1e-9"})
    void anythingElseIsRefused(String text) {
        assertThatThrownBy(() -> Range.parse(text))
                .isInstanceOf(TypeConversionException.class)
                .hasMessageStartingWith("'" + text + "' is not a range");
    }

    private static MethodPlan plan(double tolerance) {
        Patch lines =
                CommandLine.populateCommand(new PatchOptions(), "lamellar").load(Choices.none());
        return new FullMethod(TableChoices.within(tolerance), GaussianArea.STANDARD, FresnelFactor.ONCE)
                .plan(Surface.of(lines), VisibleRange.all());
    }

    @Test
    void aFinerToleranceIsAdvisedOnlyWhereAPlanCanKeepIt() {
        assertThat(CertifyOption.remedy(Choices.none(), plan(1e-3))).startsWith("give a finer --tolerance");
        assertThat(CertifyOption.remedy(Choices.none(), plan(1e-5)))
                .startsWith("no finer --tolerance helps")
                .contains("--method reference");
    }

    /** Writes a grating in text: 40 x 20 samples, 4 um wide, tilted by 39 nm. */
    private Path scan() throws IOException {
        return scan("scan.txt", "", 40, 20, (column, row) -> column + 20 * Math.sin(2 * Math.PI * column / 7.3));
    }

    private Patch load(Choices method) throws IOException {
        String[] words = {"--patch", scan().toString(), "--width", "4um", "--height-unit", "nm"};
        return CommandLine.populateCommand(new PatchOptions(), words).load(method);
    }

    @Test
    void theThesisTakesAScanThatIsGivenDirectlyAsItIs() throws IOException {
        Choices thesis = parse("--preset thesis");
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
        Choices standard = Choices.none();
        Patch patch = load(standard);
        assertThat(patch.source()).contains("levelling plane", "edges blended");
        assertThat(ScanLimit.of(standard, patch).choices().get(MethodSettings.COHERENCE_LENGTH))
                .isEqualTo(patch.heights().width());
    }
}
