package sunbeam.app.setup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.resample.PeriodInterpolation;

class MethodOptionsTest {
    private static MethodRequest parse(String options) {
        CommandLine line = new CommandLine(new MethodOptions()).setCaseInsensitiveEnumValuesAllowed(true);
        MethodOptions parsed = line.getCommand();
        line.parseArgs(options.isEmpty() ? new String[0] : options.split(" "));
        return parsed.request();
    }

    @Test
    void fullIsTheDefault() {
        assertThat(parse("")).isEqualTo(MethodRequest.of(MethodKind.FULL));
    }

    @Test
    void aMethodTakesItsOwnOptions() {
        MethodRequest request = parse("--method pq --interpolation linear --replicas 7");
        assertThat(request.interpolation()).isEqualTo(PeriodInterpolation.LINEAR);
        assertThat(request.replicas()).hasValue(7);
        assertThat(request.describe()).isEqualTo("pq, linear, replicas 7");
        assertThat(parse("--method gem --spacing 1.6um").describe()).contains("for comparison only");
    }

    @ParameterizedTest
    @CsvSource({
        "--method nmm --interpolation sinc, --interpolation, pq",
        "--method full --replicas 3, --replicas, pq or reference",
        "--spacing 1um, --spacing, gem",
        "--method pq --replicas 0, --replicas 0, 1 to 10000",
        "--method gem --spacing 1nm, --spacing, 100 nm"
    })
    void whatDoesNotFitIsRefusedWithTheRemedy(String options, String option, String remedy) {
        assertThatThrownBy(() -> parse(options))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining(option)
                .hasMessageContaining(remedy);
    }

    @Test
    void lengthsNeedAUnit() {
        assertThatThrownBy(() -> parse("--method gem --spacing 3")).hasMessageContaining("spacing");
    }
}
