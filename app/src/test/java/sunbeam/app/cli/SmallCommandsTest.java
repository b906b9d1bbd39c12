package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import jrtr.GraphicsException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import sunbeam.app.cli.DoctorCommand.Check;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTablesFile;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableLabel;

/** Commands about the cache, the machine, its speed, and meshes. */
final class SmallCommandsTest extends CommandLineFixture {
    private Path cache;

    @BeforeEach
    void makeCache() throws IOException {
        cache = Files.createDirectories(folder.resolve(".cache/sunbeam"));
    }

    private int run(String line) {
        forgetOutput();
        return sunbeam(line);
    }

    private Path table(String name, int used) throws IOException {
        Path file = cache.resolve(name + ".tables");
        ShaderTables tables = new ShaderTables.Builder("full_grid")
                .array(TableArray.of(ArrayLayout.flat("numbers", 1000, 1, 1), new float[1000]))
                .build(1, 1);
        ShaderTablesFile.write(file, name, new TableLabel(name + "'s skin", "a plan for " + name), tables);
        return Files.setLastModifiedTime(file, FileTime.fromMillis(1_700_000_000_000L + 1000L * used));
    }

    @Test
    void aPatchBesideASceneReplacesItsPatchInAPage() {
        // The page is that of the scene, and what it lacks is the patch.
        assertComplaint(
                ExitCode.UNUSABLE_INPUT,
                "export elaphe --patch none.npy --format html --output @x.html",
                "none.npy is neither");
        assertComplaint(
                ExitCode.USAGE,
                "export elaphe --patch disc --format npz --output @x.npz",
                "npz has no scene, which 'elaphe' names",
                "--format html");
        assertComplaint(
                ExitCode.USAGE, "export sinusoid --patch blaze --format html --output @x.html", "both name a patch");
    }

    @Test
    void listsWhatForWhichSurfaceHowLargeAndWhenUsedTheLastUsedFirst() throws IOException {
        table("first", 0);
        table("second", 90);
        Files.write(cache.resolve("damaged.tables"), new byte[10]);
        Files.write(cache.resolve("not-ours.txt"), new byte[10]);
        assertThat(run("cache")).isZero();
        assertThat(out.toString()).startsWith(cache + ": 3 files, 8.").doesNotContain("not-ours");
        assertThat(out.toString().lines().skip(3))
                .satisfiesExactly(
                        line -> assertThat(line).contains("10 B", "?", "not usable", "truncated"),
                        line -> assertThat(line)
                                .contains("4.", " kB", "2023-11-1", "second's skin", "a plan for second"),
                        line -> assertThat(line).contains("first's skin", "a plan for first"));
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void clearingLeavesWhatIsNoTableAndWhatOthersRead() throws IOException {
        Path file = table("open", 0);
        ShaderTables read = ShaderTablesFile.read(file, "open");
        Path foreign = Files.write(cache.resolve("not-ours.txt"), new byte[10]);
        Path halfWritten = Files.write(cache.resolve(".sunbeam-00000000-1-0.part"), new byte[10]);
        assertThat(run("cache --clear")).isZero();
        assertThat(out.toString()).contains("removed 1 file, 4.");
        assertThat(cache.toFile().listFiles()).containsExactlyInAnyOrder(foreign.toFile(), halfWritten.toFile());
        FloatBuffer layer = read.arrays().get(0).layer(0);
        assertThat(layer.get(999)).as("read from a file that is gone").isZero();
    }

    @Test
    void aMissingFolderIsAnEmptyCache() throws IOException {
        Files.delete(cache);
        assertThat(run("cache")).isZero();
        assertThat(out.toString()).isEqualTo(cache + ": 0 files, 0 B of at most 2.0 GB\n");
        assertThat(run("cache --clear")).isZero();
        assertThat(cache).doesNotExist();
    }

    private int doctor(Map<String, String> variables, Supplier<List<Check>> graphics, String... arguments) {
        CommandLine commandLine = new CommandLine(new DoctorCommand(new Environment(variables, folder), graphics));
        commandLine.setOut(new PrintWriter(out));
        return commandLine.execute(arguments);
    }

    private List<Check> working() {
        return List.of(Check.ok("GL renderer", "llvmpipe"), Check.ok("GL version", "4.5"));
    }

    private List<Check> none() {
        throw new GraphicsException("no display; install xvfb");
    }

    @Test
    void allIsWellWhereRenderingWorks() {
        assertThat(doctor(Map.of("DISPLAY", ":99"), this::working)).isZero();
        assertThat(out.toString())
                .contains("Java", "Cores", "Heap", "Free memory", ":99", "GL renderer", "llvmpipe")
                .contains(
                        folder.resolve(".cache").resolve("sunbeam") + ", 0 B used of 2.0 GB allowed, ",
                        " free on the disk");
        assertThat(out.toString().lines()).allMatch(line -> line.startsWith("ok    "));
    }

    @Test
    void programsReadTheReportAsJson() throws IOException {
        assertThat(doctor(Map.of("DISPLAY", ":99"), this::none, "--json")).isEqualTo(5);

        JsonNode report = new ObjectMapper().readTree(out.toString());
        assertThat(report.get("renders").booleanValue()).isFalse();
        List<JsonNode> failed = report.get("checks")
                .valueStream()
                .filter(check -> !check.get("ok").booleanValue())
                .toList();
        assertThat(failed).singleElement().satisfies(check -> {
            assertThat(check.get("name").textValue()).isEqualTo("Graphics");
            assertThat(check.get("remedy").textValue()).isEqualTo("no display; install xvfb");
        });
    }

    @Test
    void whatRenderingDoesNotNeedDoesNotDecide() {
        assertThat(doctor(Map.of("XDG_CACHE_HOME", "/dev/null", "DISPLAY", ":99"), this::working))
                .isZero();
        assertThat(out.toString()).contains("FAIL  Cache folder").contains("XDG_CACHE_HOME");
    }

    private MeshSource.Loaded loadMesh(String name) {
        return MeshSource.of(folder.resolve(name).toString()).load();
    }

    @Test
    void everyBuiltInMeshIsWritten() {
        for (String name : BuiltInMeshes.names()) {
            assertSuccess(sunbeam("mesh " + name + " --output @" + name + ".obj"));
            assertThat(loadMesh(name + ".obj").mesh().triangles())
                    .isEqualTo(BuiltInMeshes.create(name).triangles());
        }
        assertThat(err.toString()).isEmpty();
        assertThat(out.toString()).containsPattern("snake\\.obj: \\d+ vertices, \\d+ triangles");
    }

    @Test
    void anObjFileIsCheckedAndCompleted() throws IOException {
        Files.writeString(folder.resolve("in.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 1 2\n");
        assertSuccess(sunbeam("mesh @in.obj --output @out.obj"));
        assertThat(err.toString().lines())
                .hasSize(3)
                .allMatch(line -> line.startsWith("sunbeam: warning: ") && line.contains("in.obj"));
        assertThat(out.toString()).contains("out.obj: 3 vertices, 1 triangle, 1.00 x 1.00 x 0.00 m\n");
        assertThat(loadMesh("out.obj").warnings()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"obj", "ply", "glb"})
    void theFilesNameChoosesTheFormat(String ending) {
        assertSuccess(sunbeam("mesh plane --output @plane." + ending));
        assertThat(loadMesh("plane." + ending).mesh().triangles())
                .isEqualTo(BuiltInMeshes.create("plane").triangles());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        plane --output a.stl                      | USAGE          | a.stl
        snake --texture dark --output @worn.obj   | USAGE          | --texture dark needs a format with pictures
        plane --scales keeled --output @worn.glb  | USAGE          | --scales keeled is for mesh snake
        plane --mesh-unit mm --output @worn.glb   | UNUSABLE_INPUT | in meters
        """)
    void whatAFormatOrAMeshDoesNotHaveIsRefused(String words, ExitCode code, String reason) {
        assertComplaint(code, "mesh " + words, reason);
    }

    /** A short window and a coarse tolerance make small tables. */
    private static final String SMALL_TABLES = " --size 16 --samples 4 --coherence-length 4um";

    @Test
    @NeedsDisplay
    void oneMethodStandsBesideTheThesisOnEachSurface() throws IOException {
        assertSuccess(sunbeam(
                "benchmark --json --patch lamellar --patch lamellar --method table --tolerance 1e-2" + SMALL_TABLES));

        JsonNode rows = new ObjectMapper().readTree(out.toString()).get("measured");
        assertThat(rows.findValuesAsText("patch")).containsExactly("lamellar", "lamellar", "lamellar-2", "lamellar-2");
        assertThat(rows.findValuesAsText("method"))
                .containsExactly("full, thesis", "table, tolerance 1e-2", "full, thesis", "table, tolerance 1e-2");
        for (int i = 1; i < 4; i += 2) {
            JsonNode table = rows.get(i);
            // Most views of a grating are too dark to measure an error.
            assertThat(table.get("views").intValue()).isBetween(1, 4);
            // The median is promised; the 95th percentile of so few views is nearly the largest error, which is not.
            assertThat(table.get("median_error_of_xyz").doubleValue()).isLessThanOrEqualTo(1e-2);
            assertThat(table.get("bytes").longValue()).isPositive();
        }
    }

    @Test
    @NeedsDisplay
    void thePageHasEveryMethodAndItsNumbers() throws Exception {
        Path page = folder.resolve("speed.md");
        String words = "benchmark --patch lamellar --tolerance 1e-1 --output " + page + SMALL_TABLES;

        assertSuccess(sunbeam(words));

        String[] rows = {
            "| full, thesis",
            "| full, tolerance 1e-1",
            "| table, tolerance 1e-1",
            "| nmm, tolerance 1e-1",
            "| nmm, preset thesis",
            "| pq, tolerance 1e-1 ",
            "| pq, tolerance 1e-1, linear",
            "| pq, preset thesis",
            "| gem"
        };
        assertThat(page).content().contains("\n## lamellar\n", "(speed/lamellar-methods.png)");
        assertThat(page).content().contains(rows);
        assertThat(out.toString()).as("printed, too").contains(rows);
        assertThat(ImageIO.read(folder.resolve("speed/lamellar-methods.png").toFile()))
                .isNotNull();
        List<String> numbers = Files.readAllLines(folder.resolve("speed/benchmark.csv"));
        assertThat(numbers.get(0)).startsWith("patch,method,pixels,");
        assertThat(numbers).hasSize(1 + rows.length);
        assertThat(numbers.get(rows.length))
                .as("a method without a scale has no error")
                .contains(",0,NaN,NaN,NaN,");
        assertThat(sunbeam(words)).as("an earlier benchmark's page stays").isEqualTo(ExitCode.OUTPUT_EXISTS.code());
    }

    @Test
    @NeedsDisplay
    void complexityIsMeasuredOverEachQuantity() throws IOException {
        Path page = folder.resolve("cost.md");

        assertSuccess(sunbeam("benchmark --complexity --patch lamellar --size 16 --output " + page));

        for (String series :
                List.of("full: wavelengths", "full: terms", "full: bins", "full: samples", "nmm: periods")) {
            assertThat(page).content().contains("| " + series + " x 1.00 ").contains("(cost/lamellar-complexity.png)");
        }
        assertThat(folder.resolve("cost/lamellar-complexity.png")).isNotEmptyFile();
        assertThat(sunbeam("benchmark --complexity --method nmm")).isEqualTo(2);
        assertThat(err.toString()).contains("--complexity", "leave out --method");
    }

    @Test
    void whatIsWrongIsToldBeforeAnythingIsMeasured() {
        assertThat(sunbeam("benchmark --samples -1")).isEqualTo(2);
        assertThat(sunbeam("benchmark --patch lamellar --patch no-such-patch")).isEqualTo(4);
        assertThat(sunbeam("benchmark --patch lamellar --output " + folder.resolve("speed")))
                .isEqualTo(2);
        assertThat(sunbeam("benchmark --patch lamellar --output " + folder.resolve(".md")))
                .isEqualTo(2);
        assertThat(out.toString()).isEmpty();
        assertThat(err.toString().lines()).hasSize(4);
        assertThat(err.toString()).contains("--samples -1", "no-such-patch", "--output", ".md");
        assertThat(folder.toFile().list()).as("of this test").containsExactly(".cache");
    }
}
