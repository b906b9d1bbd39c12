package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Validates the JSON of every command by docs/reference/report.schema.json, which names all fields. */
final class ReportSchemaTest extends CommandLineFixture {

    private final ObjectMapper json = new ObjectMapper();

    @BeforeEach
    void prepare() throws IOException {
        Files.writeString(folder.resolve("directions.csv"), "theta_i,phi_i,theta_r,phi_r\n0,0,12.7,0\n");
        Files.writeString(folder.resolve("scene.json"), SCENE);
    }

    private JsonNode report(int expected, String words) throws IOException {
        forgetOutput();
        assertThat(sunbeam(words)).as("%s", err).isEqualTo(expected);
        return json.readTree(out.toString());
    }

    private Set<ValidationMessage> mistakes(JsonNode report) throws IOException {
        JsonNode schema =
                json.readTree(Path.of("../docs/reference/report.schema.json").toFile());
        return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                .getSchema(schema)
                .validate(report);
    }

    /** Returns the JSON of all files of the folder: whole files, lines, and entries of archives; no scenes. */
    private List<JsonNode> written() throws IOException {
        List<JsonNode> reports = new ArrayList<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = file.getFileName().toString();
                if (name.endsWith(".json") && !name.endsWith("scene.json")) {
                    reports.add(json.readTree(file.toFile()));
                } else if (name.endsWith(".jsonl")) {
                    for (String line : Files.readAllLines(file)) {
                        reports.add(json.readTree(line));
                    }
                } else if (name.endsWith(".npz")) {
                    try (ZipFile archive = new ZipFile(file.toFile())) {
                        reports.add(json.readTree(archive.getInputStream(archive.getEntry("metadata.json"))));
                    }
                }
            }
        }
        return reports;
    }

    private static Set<String> names(JsonNode node) {
        Set<String> names = new TreeSet<>();
        node.fieldNames().forEachRemaining(names::add);
        node.forEach(part -> names.addAll(names(part)));
        return names;
    }

    /** Exit code, number of JSON files and command line of each kind of report. */
    private static final String COMMANDS = """
            0 0 inspect sinusoid --output @i.png
            0 1 color blaze --angles -40:40:8 --output @c.png
            0 0 brdf-map blaze --size 33 --certify 2 --tolerance 0.05 --output @m.png
            0 1 evaluate blaze --azimuth 0 --wavelengths 500:600:10 --output @e
            4 0 evaluate bumps --output @e
            0 1 orders blaze --wavelengths 500:600:50 --output @o
            0 0 reflectance --patch blaze --directions @directions.csv --certify 1 --tolerance 0.05 --output @r.csv
            0 1 sample sinusoid --count 40 --tolerance 0.05 --coherence-length 4um --output @s.npz
            0 0 precompute --patch sinusoid --tolerance 0.1 --output @p.h5
            0 0 precompute --patch sinusoid --picture @p.png
            0 0 benchmark --patch lamellar --size 16 --samples 4 --coherence-length 4um --output @b.md
            0 0 render @scene.json --size 48x36 --output @v.png
            0 1 export sinusoid --format npz --samples 1 --tolerance 0.05 --coherence-length 8um --output @x.npz
            0 1 export sinusoid --format glsl --samples 0 --tolerance 0.05 --coherence-length 4um --size 1MB --output @x
            0 1 figures --only 2.11 --quick --output @f
            0 0 mesh plane --output @plane.obj
            0 0 cache
            0 0 cache --clear
            0 0 compare @photo.png @scene.json --output @compared.png
            4 2 inspect blaze @directions.csv --output @all
            0 4 color blaze --theta-i 0:20:20 --angles -40:40:40 --output @all
            0 2 brdf-map blaze sinusoid --size 16 --tolerance 0.05 --output @all
            0 4 orders blaze sinusoid --wavelengths 500:600:50 --output @all
            4 3 evaluate blaze @directions.csv --azimuth 0 --wavelengths 500:600:50 --output @all
            """;

    static Stream<Arguments> commands() {
        return COMMANDS.lines().map(line -> line.split(" ", 3)).map(words -> Arguments.of((Object[]) words));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void standardOutputAndFilesAreAsTheSchemaSays(int code, int files, String words) throws IOException {
        if (words.startsWith("compare")) {
            assertSuccess(sunbeam("render @scene.json --size 48x36 --output @photo.png"));
        }
        String[] parts = words.split(" ", 2);

        JsonNode report = report(code, parts[0] + " --json" + (parts.length > 1 ? " " + parts[1] : ""));

        assertThat(report.at("/command").asText()).isEqualTo(parts[0]);
        assertThat(report.has("files")).isTrue();
        assertThat(mistakes(report)).isEmpty();
        assertThat(names(report)).allMatch(name -> name.matches("[a-z][a-z0-9]*(_[a-z0-9]+)*|[XYZ]"));
        List<JsonNode> written = written();
        assertThat(written).hasSize(files);
        for (JsonNode file : written) {
            assertThat(mistakes(file)).isEmpty();
        }
    }

    /** Doctor depends on the machine: its exit code and its checks are SmallCommandsTest's. */
    @Test
    void everyCommandWithJsonIsHere() {
        assertThat(sunbeam("--help")).isZero();
        List<String> all = Pattern.compile("(?m)^  ([a-z-]+)  ")
                .matcher(out.toString().replaceFirst("(?s).*Commands:", ""))
                .results()
                .map(match -> match.group(1))
                .filter(name -> !name.equals("help"))
                .toList();
        assertThat(all).contains("render", "cache").hasSizeGreaterThan(15);
        for (String command : all) {
            forgetOutput();
            assertThat(sunbeam(command + " --help-all")).isZero();
            if (out.toString().contains("--json") && !command.equals("doctor")) {
                assertThat(COMMANDS.lines())
                        .as("a line for it")
                        .anyMatch(line -> line.split(" ", -1)[2].equals(command));
            }
        }
    }

    @Test
    void theReportOfDoctorIsAsTheSchemaSays() throws IOException {
        forgetOutput();
        sunbeam("doctor --json");
        assertThat(mistakes(json.readTree(out.toString()))).isEmpty();
    }

    /** The root of the schema refuses what no command prints, and a report without one of its fields. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "{}",
                "[1]",
                "{\"anything\": 1}",
                "{\"command\": \"mesh\"}",
                "{\"command\": \"view\", \"files\": []}",
                "{\"command\": \"inspect\", \"mesh\": \"plane\", \"vertices\": 4, \"triangles\": 2, \"sides_m\": [], \"files\": []}",
                "{\"command\": \"mesh\", \"mesh\": \"plane\", \"vertices\": 4, \"triangles\": 2, \"sides_m\": [], \"files\": [], \"x_cm\": 1}"
            })
    void otherJsonIsNoReport(String text) throws IOException {
        assertThat(mistakes(json.readTree(text))).isNotEmpty();
    }
}
