package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.LevelGrid;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.method.LevelledPlan;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;

/**
 * How long all colors of a surface take, for whatever light and mesh: makes the numbers of docs/color-tables.md. Not among the tests:
 * {@code ./sunbeam test -Dtest=AllLightsRun -Dsurefire.failIfNoSpecifiedTests=false}, with {@code -Dsunbeam.patch=NAME} and {@code
 * -Dsunbeam.tolerance=T}. Nothing is read from the cache and nothing kept.
 */
class AllLightsRun {
    private static final int PAGES_TOGETHER = 16_000;

    @TempDir
    private Path home;

    @Test
    void printTimes() {
        String name = System.getProperty("sunbeam.patch", "elaphe-like");
        double tolerance = Double.parseDouble(System.getProperty("sunbeam.tolerance", "1e-2"));
        long begin = System.nanoTime();
        Patch patch = CommandLine.populateCommand(new PatchOptions()).load(name);
        DiffractionSetup setup = new DiffractionSetup(patch, new Environment(Map.of(), home), line -> {});
        LevelledPlan plan = new TableMethod(tolerance, GaussianArea.STANDARD.with(Average.ENSEMBLE))
                .plan(setup.surface(), VisibleRange.all())
                .levelled()
                .orElseThrow();
        LevelsOfSetup sources = new LevelsOfSetup(setup, plan, setup.cie());
        List<TableLevels.Level> levels = plan.levels().levels();
        long all = 0;
        for (int level = levels.size() - 1; level >= 0; level--) {
            long before = System.nanoTime();
            long places = bake(LevelGrid.of(levels.get(level)), sources, level);
            all += places;
            System.out.printf(
                    Locale.ROOT,
                    "level %d, step %.4f: %.2f million places, %.1f s%n",
                    level,
                    levels.get(level).design().step(),
                    places * 1e-6,
                    seconds(before));
        }
        System.out.printf(
                Locale.ROOT,
                "%s, tolerance %.0e, all levels: %.1f million places, %.1f s from the heights on%n",
                name,
                tolerance,
                all * 1e-6,
                seconds(begin));
        assertThat(all).isPositive();
    }

    private static double seconds(long since) {
        return (System.nanoTime() - since) * 1e-9;
    }

    private static long bake(LevelGrid grid, LevelsOfSetup sources, int level) {
        LevelBaking baking = new LevelBaking(grid, sources.levels().numbers());
        BitSet reachable = grid.reachable();
        long places = baking.missing(reachable);
        int[] pages = grid.bySide(reachable).toArray();
        try (ColorSource source = sources.open(level, done -> {})) {
            for (int from = 0; from < pages.length; from += PAGES_TOGETHER) {
                BitSet some = new BitSet();
                IntStream.range(from, Math.min(pages.length, from + PAGES_TOGETHER))
                        .forEach(i -> some.set(pages[i]));
                assertThat(baking.bake(some, source)).hasSize(some.cardinality());
            }
        }
        return places;
    }
}
