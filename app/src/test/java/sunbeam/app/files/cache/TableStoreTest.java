package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ColorSources;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.method.TableSources;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableLabel;

/** Tables are made once, and come back as they were made. */
class TableStoreTest {
    @TempDir
    private Path home;

    private final List<String> warnings = new ArrayList<>();

    /** Tables of one array, and how often they were made. */
    private static final ColorSources NO_COLORS = (tables, places) -> {
        throw new AssertionError("no colors are needed");
    };

    /** A plan of next to nothing. */
    private abstract static class SmallPlan implements MethodPlan {
        private final String key;

        SmallPlan(String key) {
            this.key = key;
        }

        @Override
        public String summary() {
            return "counted";
        }

        @Override
        public List<String> reasons() {
            return List.of();
        }

        @Override
        public MemoryNeed memory() {
            return MemoryNeed.of(0, List.of());
        }

        @Override
        public String key(MethodUse use) {
            return key + use;
        }
    }

    private static final class Counted extends SmallPlan {
        private int made;

        Counted(String key) {
            super(key);
        }

        @Override
        public ShaderTables tables(MethodUse use, TableSources sources) {
            made++;
            return new ShaderTables.Builder("counted")
                    .array(TableArray.of(ArrayLayout.flat("numbers", 3, 1, 1), new float[] {1, 2, 3}))
                    .build(1, 1);
        }
    }

    private static Surface surface(String name) {
        HeightMap map = BuiltInPatches.generate("blaze");
        PatchIdentity identity =
                new PatchIdentity(name, map.columns(), map.rows(), map.pitchX(), map.pitchY(), map.digest());
        return new Surface(map, HeightLevels.of(map), identity, CieTable.load());
    }

    private TableStore store(String name) {
        return new TableStore(surface(name), new Environment(Map.of(), home), note -> {}, warnings::add);
    }

    private List<Path> kept() throws Exception {
        try (Stream<Path> files = Files.list(home.resolve(".cache/sunbeam"))) {
            // Locks stay beside the tables.
            return files.filter(file -> !file.toString().endsWith(".lock"))
                    .filter(file -> !file.endsWith("limit"))
                    .toList();
        }
    }

    private static float[] numbers(ShaderTables tables) {
        FloatBuffer layer = tables.arrays().get(0).layer(0);
        float[] values = new float[layer.remaining()];
        layer.get(values);
        return values;
    }

    @Test
    void whatIsThereIsNotMadeAgain() {
        Counted plan = new Counted("plan");

        ShaderTables first = store("a").tables(plan, MethodUse.COLOR, NO_COLORS);
        ShaderTables second = store("a").tables(plan, MethodUse.COLOR, NO_COLORS);

        assertThat(plan.made).isOne();
        assertThat(numbers(first)).containsExactly(1, 2, 3);
        assertThat(numbers(second)).containsExactly(1, 2, 3);
        store("a").tables(plan, MethodUse.SPECTRAL, NO_COLORS);
        assertThat(plan.made).as("another use").isEqualTo(2);
        assertThat(warnings).isEmpty();
    }

    @Test
    void whatIsReadCountsAsUsedAndSaysWhatItIs() throws Exception {
        store("a").tables(new Counted("plan"), MethodUse.COLOR, NO_COLORS);
        Path file = kept().get(0);
        Files.setLastModifiedTime(file, FileTime.fromMillis(0));
        store("a").tables(new Counted("plan"), MethodUse.COLOR, NO_COLORS);
        CacheFolder folder = CacheFolder.of(new Environment(Map.of(), home));
        assertThat(folder.entries()).hasSize(1);
        assertThat(Files.getPosixFilePermissions(file))
                .as("nobody else reads it")
                .isEqualTo(PosixFilePermissions.fromString("rw-------"));
        CacheEntry entry = folder.entries().get(0);
        assertThat(entry.lastUsed()).isAfter(Instant.now().minusSeconds(600));
        assertThat(entry.label())
                .isEqualTo(TableLabel.of("a", surface("a").identity().digest(), "counted"));
    }

    @Test
    void withoutACacheFolderTablesAreMadeEachTime() throws Exception {
        Files.createFile(home.resolve(".cache"));
        Counted plan = new Counted("plan");

        assertThat(numbers(store("a").tables(plan, MethodUse.COLOR, NO_COLORS))).containsExactly(1, 2, 3);
        assertThat(numbers(store("a").tables(plan, MethodUse.COLOR, NO_COLORS))).containsExactly(1, 2, 3);

        assertThat(plan.made).isEqualTo(2);
        assertThat(warnings).hasSize(2).allMatch(line -> line.startsWith("no cache"));
    }

    @Test
    void aFourierTableComesBackUnderTheNameThatTheSurfaceHasNow() {
        Surface surface = surface("old name");
        Plan plan = FullMethod.thesis().tablePlan(surface, VisibleRange.of(new Direction(0, 0, 1)));
        FourierTable made = store("old name").table(plan);

        FourierTable read = store("new name").table(plan);

        assertThat(read.patch().name()).isEqualTo("new name");
        assertThat(read.real()).isDeepEqualTo(made.real());
        assertThat(read.imaginary()).isDeepEqualTo(made.imaginary());
        assertThat(warnings).isEmpty();
    }

    /** Asks for colors twice, as a table does that its trial makes finer; the first ones are 1, the others 2. */
    private static final class MadeTwice extends SmallPlan {
        MadeTwice() {
            super("twice");
        }

        @Override
        public ShaderTables tables(MethodUse use, TableSources sources) {
            ShaderTables none = new ShaderTables.Builder("counted").build(1, 1);
            float[] numbers = new float[3];
            for (int time = 0; time < 2; time++) {
                try (ColorSource source = sources.colors(none, 1)) {
                    numbers[time] = source.xyz(new float[] {0.1f, 0.2f, -time})[0];
                }
            }
            return new ShaderTables.Builder("counted")
                    .array(TableArray.of(ArrayLayout.flat("numbers", 3, 1, 1), numbers))
                    .build(1, 1);
        }
    }

    @Test
    void whoIsStoppedWhileATableIsMadeAgainGoesOnThere() throws Exception {
        List<Float> evaluated = new ArrayList<>();
        ColorSources stopping = (tables, places) -> uvw -> {
            if (uvw[2] < 0) {
                throw new IllegalStateException("stopped");
            }
            evaluated.add(uvw[2]);
            return new float[] {1, 1, 1};
        };
        ColorSources going = (tables, places) -> uvw -> {
            evaluated.add(uvw[2]);
            return new float[] {2, 2, 2};
        };

        assertThatThrownBy(() -> store("a").tables(new MadeTwice(), MethodUse.COLOR, stopping))
                .hasMessage("stopped");
        ShaderTables made = store("a").tables(new MadeTwice(), MethodUse.COLOR, going);

        assertThat(numbers(made)).containsExactly(1, 2, 0);
        assertThat(evaluated).as("each once").containsExactly(0f, -1f);
        assertThat(kept()).as("nothing half made is left").hasSize(1);
        assertThat(warnings).isEmpty();
    }
}
