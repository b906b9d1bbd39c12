package sunbeam.app.measure.performance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.shader.ShaderTables;

/** The parts of the time make up the whole, also where a table is made again. */
class BakeTimesTest {
    @Test
    void aTableThatIsMadeTwiceTakesBothTimes() {
        BakeTimes.Clock clock = new BakeTimes.Clock((tables, places) -> uvw -> new float[uvw.length]);
        assertThat(clock.used()).isFalse();
        ShaderTables none = new ShaderTables.Builder("none").build(1, 1);
        for (int count : new int[] {100, 250}) {
            try (ColourSource source = clock.of(none, count + 10_000)) {
                source.xyz(new float[3 * count]);
                source.xyz(new float[3 * 7]);
            }
        }
        BakeTimes times = clock.times();
        assertThat(clock.used()).isTrue();
        assertThat(times.places()).isEqualTo(100 + 250 + 2 * 7);
        assertThat(times.rest()).isNotNegative();
        assertThat(times.spectra()).isNotNegative();
    }
}
