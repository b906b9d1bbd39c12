package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.LevelBaking.CachedTiles;
import sunbeam.precompute.colortable.RadialBaker;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTables.MethodUse;
import sunbeam.precompute.plan.ShaderTablesFile.TableLabel;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.spectrum.PowerSpectrum;

/** Tables are made once, and are read back unchanged. */
class DiffractionSetupTest {
    @TempDir
    private Path home;

    private final List<String> warnings = new ArrayList<>();

    /** A tiny plan, which counts how often its tables are made. */
    private static MethodPlan counted(AtomicInteger made) {
        return new MethodPlan(
                "counted",
                List::of,
                Optional.empty(),
                Optional.empty(),
                new MemoryNeed(0, List.of()),
                EnumSet.allOf(MethodUse.class),
                () -> "plan",
                (use, sources) -> {
                    made.incrementAndGet();
                    return new ShaderTables.Builder("counted")
                            .array(TableArray.of(ArrayLayout.flat("numbers", 3, 1, 1), new float[] {1, 2, 3}))
                            .build(1, 1);
                });
    }

    private static Surface surface(String name) {
        HeightMap map = BuiltInPatches.generate("blaze");
        return new Surface(map, name, map.digest(), CieTable.load());
    }

    private DiffractionSetup setup(String name) {
        CacheFolder folder = CacheFolder.of(new Environment(Map.of(), home));
        return new DiffractionSetup(
                null,
                surface(name),
                folder,
                warnings::add,
                new ValidatedTable.Diagnostics(note -> {}, warnings::add),
                new Environment(Map.of(), Path.of("")).progress());
    }

    private List<Path> cached() throws Exception {
        try (Stream<Path> files = Files.list(home.resolve(".cache/sunbeam"))) {
            return files.filter(file -> !file.endsWith("limit")).toList();
        }
    }

    private ShaderTables tables(MethodPlan plan, MethodUse use) {
        return setup("a").tables(plan, use);
    }

    private String oneLight(MethodPlan plan) {
        return setup("a").freshTables(plan, MethodUse.COLOR).defines().get("COLOR_ONE_LIGHT");
    }

    private static float[] numbers(ShaderTables tables) {
        FloatBuffer layer = tables.arrays().get(0).layer(0);
        float[] values = new float[layer.remaining()];
        layer.get(values);
        return values;
    }

    @Test
    void cachedTablesAreNotMadeAgain() {
        AtomicInteger made = new AtomicInteger();
        MethodPlan plan = counted(made);

        ShaderTables first = tables(plan, MethodUse.COLOR);
        ShaderTables second = tables(plan, MethodUse.COLOR);

        assertThat(made.get()).isOne();
        assertThat(numbers(first)).containsExactly(1, 2, 3);
        assertThat(numbers(second)).containsExactly(1, 2, 3);
        tables(plan, MethodUse.SPECTRAL);
        assertThat(made.get()).as("another use").isEqualTo(2);
        assertThat(warnings).isEmpty();
    }

    @Test
    void readFilesCountAsUsedAndHaveALabel() throws Exception {
        tables(counted(new AtomicInteger()), MethodUse.COLOR);
        Path file = cached().get(0);
        Files.setLastModifiedTime(file, FileTime.fromMillis(0));
        tables(counted(new AtomicInteger()), MethodUse.COLOR);
        CacheFolder folder = CacheFolder.of(new Environment(Map.of(), home));
        assertThat(folder.entries()).hasSize(1);
        assertThat(Files.getPosixFilePermissions(file))
                .as("nobody else reads it")
                .isEqualTo(PosixFilePermissions.fromString("rw-------"));
        CacheFolder.Entry entry = folder.entries().get(0);
        assertThat(entry.lastUsed()).isAfter(Instant.now().minusSeconds(600));
        assertThat(entry.label()).isEqualTo(TableLabel.of("a", surface("a").digest(), "counted"));
    }

    @Test
    void withoutACacheFolderTablesAreMadeEachTime() throws Exception {
        Files.createFile(home.resolve(".cache"));
        AtomicInteger made = new AtomicInteger();
        MethodPlan plan = counted(made);

        assertThat(numbers(tables(plan, MethodUse.COLOR))).containsExactly(1, 2, 3);
        assertThat(numbers(tables(plan, MethodUse.COLOR))).containsExactly(1, 2, 3);

        assertThat(made.get()).isEqualTo(2);
        assertThat(warnings).hasSize(2).allMatch(line -> line.startsWith("no cache"));
    }

    @Test
    void aMapUsesCachedTilesOfAllLights() {
        GaussianArea area = GaussianArea.STANDARD
                .with(CoherenceWindow.ofCoherenceLength(4e-6))
                .with(Average.ENSEMBLE);
        TableMethod method = new TableMethod(1e-2, area);
        MethodPlan map = method.plan(surface("a"), VisibleRange.of(Direction.ofDegrees(20, 70)));
        assertThat(oneLight(map)).isEqualTo("1");
        ColorTablePlan all =
                method.plan(surface("a"), VisibleRange.all()).colorTable().orElseThrow();
        TileGrid grid = TileGrid.of(all.table().levels().get(0));
        BitSet tiles = grid.reachable();
        SpectrumPlan bins = all.spectrum().orElseThrow();
        PowerSpectrum spectrum = PowerSpectrum.of(setup("a").fourier(bins), 0.4 * all.tolerance());
        List<byte[]> made = new LevelBaking(grid, all.table().numbers())
                .bake(
                        tiles,
                        new RadialBaker(
                                spectrum, CieTable.load(), all.table().levels().get(0)),
                        ColorBaker.Token.NONE);
        try (CachedTiles kept = setup("a").tiles(all)) {
            int[] numbers = tiles.stream().toArray();
            kept.keep(
                    0,
                    IntStream.range(0, numbers.length).boxed().collect(Collectors.toMap(i -> numbers[i], made::get)));
        }

        assertThat(oneLight(map)).isEqualTo("0");
        MethodPlan other = method.plan(surface("a"), VisibleRange.of(Direction.ofDegrees(0, 0)));
        assertThat(oneLight(other)).isEqualTo("0");
    }
}
