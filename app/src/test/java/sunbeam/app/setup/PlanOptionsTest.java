package sunbeam.app.setup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.plan.PlanRequest;

class PlanOptionsTest {
    private static PlanOptions parse(String options) {
        CommandLine line = new CommandLine(new PlanOptions()).setCaseInsensitiveEnumValuesAllowed(true);
        PlanOptions parsed = line.getCommand();
        line.parseArgs(options.isEmpty() ? new String[0] : options.split(" "));
        return parsed;
    }

    @Test
    void theStandardToleranceNeedsNoOption() {
        assertThat(parse("").request()).isEqualTo(PlanRequest.of(PlanRequest.Preset.NONE));
        assertThat(parse("").describe()).isEqualTo("tolerance 0.001");
        assertThat(parse("--preset thesis").request()).isEqualTo(PlanRequest.of(PlanRequest.Preset.THESIS));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--tolerance 0|--tolerance 0 is out of range; give 1e-5 to 1",
                "--tolerance -1e-3|--tolerance -0.001 is out of range; give 1e-5 to 1",
                "--tolerance 1.5|--tolerance 1.5 is out of range; give 1e-5 to 1",
                "--tolerance NaN|--tolerance NaN is out of range; give 1e-5 to 1",
                "--tolerance 1e-6|--tolerance 1e-6 is finer than float32 can reach, which is 1e-5; give that or more",
                "--tolerance 1e-6|'reflectance --method reference'",
                "--preset thesis --tolerance 1e-3|--tolerance 0.001 contradicts --preset thesis",
                "--coherence-length 0m|--coherence-length 0 m is out of range; give 100 nm to 10 mm",
                "--coherence-length 11mm|--coherence-length 11 mm is out of range; give 100 nm to 10 mm",
                "--terms 501|--terms 501 is out of range; give 1 to 500",
                "--radius -1|--radius -1 is out of range; give 0 to 15",
                "--wavelength-step 300nm|--wavelength-step 300 nm is out of range; give 1 pm to 200 nm",
            })
    void whatCannotBeMeantIsRefusedWithTheRemedy(String options, String words) {
        assertThatThrownBy(() -> parse(options).request())
                .isInstanceOf(UsageException.class)
                .hasMessageContaining(words);
    }

    @ParameterizedTest
    @EnumSource(
            value = MethodKind.class,
            names = {"REFERENCE", "GEM"})
    void aMethodWithoutTablesTakesNoChoiceOfThem(MethodKind method) {
        String name = method.label();
        for (String option : new String[] {
            "--tolerance 0.01",
            "--expansion taylor",
            "--terms 5",
            "--radius 1",
            "--anchor floor",
            "--wavelength-step 5nm"
        }) {
            assertThatThrownBy(() -> parse(option).request(method))
                    .isInstanceOf(UsageException.class)
                    .hasMessage("%s is about Fourier tables, which --method %s does not use; leave it out"
                            .formatted(option.substring(0, option.indexOf(' ')), name));
        }
        assertThat(parse("--preset thesis --coherence-length 20um")
                        .request(method)
                        .isThesis())
                .isTrue();
    }
}
