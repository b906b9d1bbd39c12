package sunbeam.app.faults;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshWriter;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;
import sunbeam.precompute.table.TableFile;
import sunbeam.precompute.table.TableLabel;

/**
 * Every writer on a file system in memory of which one call fails, for every call: what stands under the output's name
 * is the old file or the new one, whole. The same with a process that is killed at that call.
 */
final class WritersUnderFaultsTest {
    private static final byte[] OLD = "what stood here before".getBytes(StandardCharsets.UTF_8);
    /** No writer makes so many calls; a loop that found no end would. */
    private static final int MOST_CALLS = 2000;

    private interface Writer {
        void write(Path target, Overwrite overwrite) throws IOException;
    }

    private static Map<String, Writer> writers() {
        BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
        Mesh plane = BuiltInMeshes.create("plane");
        Scene scene = Scenes.load("elaphe");
        ShaderTables shaderTables = shaderTables();
        FourierTable fourierTable = fourierTable();
        return Map.of(
                "PNG",
                (target, overwrite) -> PngWriter.write(target, overwrite, image, Map.of("Title", "faults")),
                "npy",
                (target, overwrite) -> NpyWriter.write(target, overwrite, new float[12], 2, 2, 3),
                "CSV",
                (target, overwrite) -> AtomicFile.write(target, overwrite, WritersUnderFaultsTest::numbers),
                "OBJ",
                (target, overwrite) -> MeshWriter.write(target, overwrite, plane),
                "scene",
                (target, overwrite) -> SceneWriter.write(target, overwrite, scene),
                "shader tables",
                (target, overwrite) -> AtomicFile.writeFile(
                        target, overwrite, file -> ShaderTablesFile.write(file, "key", TableLabel.NONE, shaderTables)),
                "HDF5",
                (target, overwrite) ->
                        AtomicFile.writeFile(target, overwrite, file -> TableFile.write(file, fourierTable)));
    }

    private static void numbers(java.io.OutputStream stream) throws IOException {
        try (CsvWriter writer = new CsvWriter(stream, List.of("one", "two"))) {
            for (int row = 0; row < 2500; row++) {
                writer.row(row, Math.sqrt(row));
            }
        }
    }

    private static ShaderTables shaderTables() {
        ArrayLayout layout = ArrayLayout.layered("terms", 5, 7, 3, 2);
        return new ShaderTables.Builder("full_grid")
                .define("TAPS", 4)
                .array(TableArray.computed(layout, number -> new float[layout.floatsPerLayer()]))
                .build(16e-6, 0.04);
    }

    private static FourierTable fourierTable() {
        double[] heights = new double[12 * 10];
        Arrays.setAll(heights, sample -> 1e-9 * sample);
        HeightLevels levels = HeightLevels.of(new HeightMap(12, 10, 50e-9, 50e-9, heights));
        return new TableBuilder(new PatchIdentity("ramp", 12, 10, 50e-9, 50e-9, "digest"), levels, done -> {})
                .build(new TaylorExpansion(HeightScale.mean(levels), 4, 5), Band.of(-2, 3), Band.of(-4, 1));
    }

    private static FileSystem memory() {
        return Jimfs.newFileSystem(Configuration.unix().toBuilder()
                .setAttributeViews("basic", "owner", "posix", "unix")
                .build());
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    /** What a writer writes when nothing fails. */
    private static byte[] whole(Writer writer) throws IOException {
        try (FileSystem system = memory()) {
            Path target = Files.createDirectory(system.getPath("/out")).resolve("target.x");
            writer.write(target, Overwrite.REFUSE);
            assertThat(names(target.getParent())).containsExactly("target.x");
            return Files.readAllBytes(target);
        }
    }

    /** One attempt with a fault, and a look at what it left. Returns whether the fault came before the writer's end. */
    private static boolean attempt(Writer writer, byte[] whole, Overwrite overwrite, Faults faults) throws IOException {
        try (FileSystem memory = memory()) {
            FileSystem system = new FaultyFileSystem(memory, faults);
            Path folder = Files.createDirectory(system.getPath("/out"));
            Path target = folder.resolve("target.x");
            boolean occupied = overwrite != Overwrite.REFUSE;
            if (occupied) {
                Files.write(target, OLD);
            }
            faults.arm();
            boolean done = false;
            boolean killed = false;
            try {
                writer.write(target, overwrite);
                done = true;
            } catch (OutputException told) {
                assertThat(told).hasMessageContaining("target.x");
            } catch (Faults.Killed end) {
                killed = true;
            } finally {
                faults.disarm();
            }
            if (!faults.happened()) {
                assertThat(done).isTrue();
                return false;
            }
            Path place = overwrite == Overwrite.NUMBER ? folder.resolve("target-2.x") : target;
            if (done) {
                assertThat(place).as("after %s, of %s", faults, names(folder)).hasBinaryContent(whole);
            }
            List<byte[]> allowed = new ArrayList<>(List.of(whole));
            if (overwrite == Overwrite.REPLACE) {
                allowed.add(OLD);
            } else if (overwrite == Overwrite.NUMBER) {
                assertThat(target).hasBinaryContent(OLD);
            }
            if (Files.exists(place)) {
                assertThat(Files.readAllBytes(place)).isIn(allowed);
            } else {
                assertThat(overwrite)
                        .as("the old file is never lost: %s", faults)
                        .isNotEqualTo(Overwrite.REPLACE);
            }
            long left = names(folder).stream()
                    .filter(name -> name.endsWith(".part"))
                    .count();
            // Only who was killed, or whose tidying up itself failed, leaves a temporary file.
            assertThat(left).isLessThanOrEqualTo(1);
            assertThat(killed || left == 0 || faults.hitDeletion()).isTrue();
            return true;
        }
    }

    @ParameterizedTest
    @EnumSource
    void theOldFileOrTheNewOneWhole(Faults.Kind kind, TestReporter reporter) throws IOException {
        int injected = 0;
        for (Map.Entry<String, Writer> entry : writers().entrySet()) {
            byte[] whole = whole(entry.getValue());
            for (Overwrite overwrite : Overwrite.values()) {
                int call = 1;
                while (attempt(entry.getValue(), whole, overwrite, new Faults(kind, call))) {
                    call++;
                    assertThat(call).as("calls of %s", entry.getKey()).isLessThan(MOST_CALLS);
                }
                injected += call - 1;
                assertThat(call)
                        .as("%s: it made calls that could fail", entry.getKey())
                        .isGreaterThan(5);
            }
        }
        reporter.publishEntry("faults injected (" + kind + ")", Integer.toString(injected));
    }

    /** The harness finds what it is made to find: writing in place loses the old file. */
    @Test
    void writingInPlaceWouldBeFound() {
        Writer inPlace = (target, overwrite) -> {
            try {
                Files.write(target, new byte[100]);
            } catch (IOException failure) {
                throw OutputException.of(target, failure);
            }
        };
        assertThat(Stream.of(1, 2, 3, 4).filter(call -> isFound(inPlace, call))).isNotEmpty();
    }

    private static boolean isFound(Writer writer, int call) {
        try {
            attempt(writer, new byte[100], Overwrite.REPLACE, new Faults(Faults.Kind.KILL, call));
            return false;
        } catch (AssertionError found) {
            return true;
        } catch (IOException unexpected) {
            throw new AssertionError(unexpected);
        }
    }
}
