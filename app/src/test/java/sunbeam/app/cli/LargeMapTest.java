package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

class LargeMapTest {
    private static final Choices ENSEMBLE = Choices.none().with(MethodSettings.AVERAGE, Average.ENSEMBLE);

    @TempDir
    Path folder;

    private DiffractionSetup setup(String patch) {
        return new DiffractionSetup(
                CommandLine.populateCommand(new PatchOptions(), patch).load(Choices.none()),
                new Environment(Map.of(), folder),
                warning -> {});
    }

    private Optional<MethodType> method(String patch) {
        return LargeMap.byTable(setup(patch), ENSEMBLE, new Direction(0, 0, 1))
                .map(chosen -> chosen.get(Methods.METHOD));
    }

    @Test
    void onlySpectraThatAreInterpolatedAreTabulated() {
        assertThat(method("elaphe-like")).contains(TableMethod.TYPE);
        // Some ten orders of a grating take a pixel of method full less time than the table's texels.
        assertThat(method("blaze")).isEmpty();
    }

    @Test
    void whatTheUserChoosesStays() {
        assertThat(LargeMap.mayHaveTable(1024, ENSEMBLE)).isTrue();
        assertThat(LargeMap.mayHaveTable(1023, ENSEMBLE)).isFalse();
        assertThat(LargeMap.mayHaveTable(1024, ENSEMBLE.with(Methods.METHOD, FullMethod.TYPE)))
                .isFalse();
        assertThat(LargeMap.mayHaveTable(1024, Choices.none().with(MethodSettings.AVERAGE, Average.COHERENT)))
                .isFalse();
    }

    @Test
    void aTableThatMissesItsToleranceIsGivenUp() {
        assertThatThrownBy(() -> LargeMap.strict(setup("blaze"))
                        .diagnostics()
                        .shortfall()
                        .accept("misses"))
                .isInstanceOf(LargeMap.TableMissed.class);
    }
}
