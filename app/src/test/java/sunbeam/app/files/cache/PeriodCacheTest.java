package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.Patch.Repetition;

class PeriodCacheTest {
    private static final int SIDE = 96;

    @TempDir
    Path folder;

    private static Patch patch(double amplitude, double noise, Repetition repetition) {
        Random random = new Random(1);
        double[] heights = new double[SIDE * SIDE];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = amplitude * Math.sin(2 * Math.PI * 12 * (i % SIDE) / SIDE) + noise * random.nextGaussian();
        }
        HeightMap map = new HeightMap(SIDE, SIDE, 1e-7, 1e-7, heights);
        return new Patch("lines", map, map, "test", List.of(), List.of(), List.of(), List.of(), repetition);
    }

    @Test
    void aCachedPeriodIsTheFoundOneAndEachSurfaceHasItsOwn() {
        List<String> warnings = new ArrayList<>();
        CacheFolder cache = CacheFolder.of(new Environment(Map.of("XDG_CACHE_HOME", folder.toString()), folder));
        PeriodCache periods = new PeriodCache(new BlobCache(Optional.of("build"), cache, warnings::add));
        // A wave with an interval, an exact period, a limit of unseen waves, none.
        for (Patch patch : List.of(
                patch(5e-8, 1e-9, Repetition.NONE),
                patch(5e-8, 0, Repetition.PERIODIC),
                patch(0, 1e-9, Repetition.NONE),
                patch(0, 0, Repetition.NONE))) {
            GratingPeriod found = GratingPeriod.of(patch);

            assertThat(periods.of(patch)).isEqualTo(found);
            assertThat(periods.of(patch)).isEqualTo(found);
        }
        assertThat(cache.entries()).hasSize(4);
        assertThat(warnings).isEmpty();
    }
}
