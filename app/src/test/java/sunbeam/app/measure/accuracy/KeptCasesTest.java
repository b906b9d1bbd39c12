package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** A drawn case that was kept is the same case when it is read again. */
final class KeptCasesTest {
    // A seed of each: powers of one window, of the ensemble, and colours.
    private static final List<Long> SEEDS = List.of(500L, 501L, 502L, 503L, 504L, 505L);

    @TempDir
    private Path folder;

    @Test
    void whatIsReadIsWhatWasDrawn() {
        KeptCases kept = new KeptCases(folder, Overwrite.REFUSE);
        SEEDS.forEach(seed -> kept.add(RandomCase.of(seed)));
        kept.close();
        List<AccuracyCase> read = AccuracyCase.readAll(folder);
        assertThat(read).hasSameSizeAs(SEEDS);
        boolean spectralSeen = false;
        for (int n = 0; n < read.size(); n++) {
            RandomCase drawn = RandomCase.of(SEEDS.get(n));
            AccuracyCase back = read.get(n);
            HeightMap map = back.patch().heights();
            FullMethod method = back.method(drawn.tolerance());
            assertThat(back.spectral()).isEqualTo(!drawn.colors());
            assertThat(map.columns()).isEqualTo(drawn.map().columns());
            assertThat(map.rows()).isEqualTo(drawn.map().rows());
            // Decimal digits of the extent; float32 of the heights, of at most 1.2 um.
            assertThat(map.pitchX())
                    .isCloseTo(drawn.map().pitchX(), within(1e-12 * drawn.map().pitchX()));
            assertThat(map.at(1, 0)).isCloseTo(drawn.map().at(1, 0), within(1e-13));
            assertThat(method.area().origin()).isEqualTo(drawn.area().origin());
            assertThat(method.area().average()).isEqualTo(drawn.area().average());
            if (back.spectral()) {
                spectralSeen = true;
                assertPowers(back, method, map);
            }
        }
        assertThat(spectralSeen).isTrue();
    }

    /** The exact values belong to the files: heights, directions and window as read. */
    private static void assertPowers(AccuracyCase back, FullMethod method, HeightMap map) {
        ReferenceEvaluator reference = new ReferenceEvaluator(
                map, method.area().window(), method.area().origin());
        boolean ensemble = method.area().average() == Average.ENSEMBLE;
        for (int row = 0; row < back.directions().size(); row += 7) {
            ReferenceEvaluator.Power power = reference.powers(
                    back.directions().pair(row), back.directions().wavelength(row));
            double exact = back.exact().at(row, ensemble ? "exact_power_ensemble" : "exact_power");
            // Thirteen digits of an angle move a far order of the widest window by 1e-8 of its width.
            assertThat(ensemble ? power.ensemble() : power.coherent()).isCloseTo(exact, within(1e-6 * exact + 1e-15));
        }
    }
}
