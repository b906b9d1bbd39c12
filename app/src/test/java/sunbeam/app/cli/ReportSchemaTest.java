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
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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

    private Set<ValidationMessage> mistakes(JsonNode report, String definition) throws IOException {
        JsonNode tree =
                json.readTree(Path.of("../docs/reference/report.schema.json").toFile());
        JsonNode wanted =
                json.createObjectNode().put("$ref", "#/$defs/" + definition).set("$defs", tree.get("$defs"));
        return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                .getSchema(wanted)
                .validate(report);
    }

    private static Set<String> names(JsonNode node) {
        Set<String> names = new TreeSet<>();
        node.fieldNames().forEachRemaining(names::add);
        node.forEach(part -> names.addAll(names(part)));
        return names;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "inspect disc --output @i.png",
                "color blaze --angles -40:40:8 --output @c.png",
                "brdf-map blaze --size 33 --certify 2 --tolerance 0.05 --output @m.png",
                "evaluate blaze --azimuth 0 --wavelengths 500:600:10 --output @e",
                "orders blaze --wavelengths 500:600:50 --output @o",
                "reflectance --patch blaze --directions @directions.csv --certify 1 --tolerance 0.05 --output @r.csv",
                "sample blaze --count 40 --tolerance 0.05 --output @s.npz",
                "precompute --patch sinusoid --tolerance 0.1 --output @p.h5",
                "precompute --patch sinusoid --picture @p.png",
                "benchmark --patch lamellar --size 16 --samples 4 --coherence-length 4um",
                "render @scene.json --size 48x36 --output @v.png",
                "export sinusoid --format npz --samples 1 --tolerance 0.05 --coherence-length 8um --output @x.npz",
                "figures --only 2.11 --quick --output @f",
                "mesh plane --output @plane.obj"
            })
    void theReportOfACommandIsAsTheSchemaSays(String words) throws IOException {
        String[] parts = words.split(" ", 2);

        JsonNode report = report(0, parts[0] + " --json " + parts[1]);

        assertThat(mistakes(report, parts[0])).isEmpty();
        assertThat(names(report)).allMatch(name -> name.matches("[a-z][a-z0-9]*(_[a-z0-9]+)*|[XYZ]"));
    }

    @Test
    void theReportOfAComparisonIsAsTheSchemaSays() throws IOException {
        report(0, "render --json @scene.json --size 48x36 --output @photo.png");
        assertThat(mistakes(report(0, "compare --json @photo.png @scene.json --output @compared.png"), "compare"))
                .isEmpty();
    }

    @Test
    void linesOfACollectionAreAsTheSchemaSays() throws IOException {
        JsonNode summary = report(4, "inspect --json blaze @directions.csv --output @all");

        assertThat(mistakes(summary, "collection")).isEmpty();
        for (String line : Files.readAllLines(folder.resolve("all/reports.jsonl"))) {
            assertThat(mistakes(json.readTree(line), "collection_row")).isEmpty();
        }
    }

    @Test
    void aFieldThatTheSchemaDoesNotHaveIsNotValid() throws IOException {
        JsonNode report =
                json.readTree("{\"mesh\": \"plane\", \"vertices\": 4, \"triangles\": 2, \"files\": [], \"x_cm\": 1}");
        assertThat(mistakes(report, "mesh")).hasSize(1);
    }
}
