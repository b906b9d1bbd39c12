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
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.LevelBaking;
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
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableLabel;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.work.Progress;

/** Tables are made once, and are read back unchanged. */
class DiffractionSetupTest {
    @TempDir
    private Path home;

    private final List<String> warnings = new ArrayList<>();
    private int made;

    /** A tiny plan, which counts how often its tables are made. */
    private final MethodPlan counted = new MethodPlan(
            "counted",
            List::of,
            Optional.empty(),
            Optional.empty(),
            new MemoryNeed(0, List.of()),
            EnumSet.allOf(MethodUse.class),
            () -> "plan",
            (use, sources) -> {
                made++;
                return new ShaderTables.Builder("counted")
                        .array(TableArray.of(ArrayLayout.flat("numbers", 3, 1, 1), new float[] {1, 2, 3}))
                        .build(1, 1);
            });

    private static Surface surface() {
        HeightMap map = BuiltInPatches.generate("blaze");
        return new Surface(map, "a", CieTable.load());
    }

    private CacheFolder folder() {
        return CacheFolder.of(new Environment(Map.of(), home));
    }

    private DiffractionSetup setup() {
        return new DiffractionSetup(
                null,
                surface(),
                folder(),
                warnings::add,
                new ValidatedTable.Diagnostics(note -> {}, warnings::add),
                new Environment(Map.of(), Path.of("")).progress());
    }

    private float[] numbers(MethodUse use) {
        FloatBuffer layer = setup().tables(counted, use).arrays().get(0).layer(0);
        float[] values = new float[layer.remaining()];
        layer.get(values);
        return values;
    }

    private String oneLight(MethodPlan plan) {
        return setup().freshTables(plan, MethodUse.COLOR).defines().get("COLOR_ONE_LIGHT");
    }

    @Test
    void cachedTablesAreNotMadeAgain() {
        assertThat(numbers(MethodUse.COLOR)).containsExactly(1, 2, 3);
        assertThat(numbers(MethodUse.COLOR)).containsExactly(1, 2, 3);
        assertThat(made).isOne();
        numbers(MethodUse.SPECTRAL);
        assertThat(made).as("another use").isEqualTo(2);
        assertThat(warnings).isEmpty();
    }

    @Test
    void readFilesCountAsUsedAndHaveALabel() throws Exception {
        numbers(MethodUse.COLOR);
        Path file = folder().entries().get(0).file();
        Files.setLastModifiedTime(file, FileTime.fromMillis(0));
        numbers(MethodUse.COLOR);
        assertThat(folder().entries()).hasSize(1);
        assertThat(Files.getPosixFilePermissions(file))
                .as("nobody else reads it")
                .isEqualTo(PosixFilePermissions.fromString("rw-------"));
        CacheFolder.Entry entry = folder().entries().get(0);
        assertThat(entry.lastUsed()).isAfter(Instant.now().minusSeconds(600));
        assertThat(entry.label()).isEqualTo(TableLabel.of("a", surface().digest(), "counted"));
    }

    @Test
    void withoutACacheFolderTablesAreMadeEachTime() throws Exception {
        Files.createFile(home.resolve(".cache"));
        assertThat(numbers(MethodUse.COLOR)).containsExactly(1, 2, 3);
        assertThat(numbers(MethodUse.COLOR)).containsExactly(1, 2, 3);
        assertThat(made).isEqualTo(2);
        assertThat(warnings).hasSize(2).allMatch(line -> line.startsWith("no cache"));
    }

    @Test
    void aMapUsesCachedTilesOfAllLights() {
        GaussianArea area =
                new GaussianArea(CoherenceWindow.ofCoherenceLength(4e-6), WindowOrigin.CENTRE, Average.ENSEMBLE);
        TableMethod method = new TableMethod(1e-2, area);
        MethodPlan map = method.plan(surface(), VisibleRange.of(Direction.ofDegrees(20, 70)));
        assertThat(oneLight(map)).isEqualTo("1");
        ColorTablePlan all =
                method.plan(surface(), VisibleRange.all()).colorTable().orElseThrow();
        TileGrid grid = TileGrid.of(all.table().levels().get(0));
        BitSet tiles = grid.reachable();
        SpectrumPlan bins = all.spectrum().orElseThrow();
        PowerSpectrum spectrum = PowerSpectrum.of(setup().fourier(bins), 0.4 * all.tolerance());
        Iterator<byte[]> baked = new LevelBaking(grid, all.table().numbers())
                .bake(
                        tiles,
                        new RadialBaker(
                                spectrum, CieTable.load(), all.table().levels().get(0)),
                        Progress.NONE)
                .iterator();
        try (CachedTiles kept = setup().tiles(all)) {
            tiles.stream().forEach(tile -> kept.keep(0, Map.of(tile, baked.next())));
        }

        assertThat(oneLight(map)).isEqualTo("0");
        MethodPlan other = method.plan(surface(), VisibleRange.of(Direction.ofDegrees(0, 0)));
        assertThat(oneLight(other)).isEqualTo("0");
    }
}
