package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tables for other programs, read by others' readers: what they hold is what {@code reflectance} says. */
class ExportTest {
    private static final String SURFACE = "--coherence-length 8um";

    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeEach
    void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    @Test
    void anArchiveSaysWhatItHoldsAndHowFarItIsFromTheReference() throws Exception {
        workplace.succeedHere(words("export blaze --format npz --output b.npz --samples 4 " + SURFACE));

        JsonNode metadata = archived("b.npz");
        assertThat(metadata.path("patch").asText()).isEqualTo("blaze");
        assertThat(metadata.path("coherence_length_metres").asDouble()).isEqualTo(8e-6);
        assertThat(metadata.path("power_scale").asDouble()).isEqualTo(1);
        assertThat(metadata.path("axes")).hasSize(3);
        JsonNode error = metadata.path("error").path("beside_reference");
        assertThat(error.path("count").asInt()).isEqualTo(4);
        assertThat(error.path("median").asDouble()).isBetween(0.0, 0.05);
    }

    @Test
    void numPyReadsTheColorsThatReflectanceTells() throws Exception {
        requireNumPy();
        workplace.succeedHere(
                words("export blaze --format npz --output b.npz --samples 0 --tolerance 0.01 " + SURFACE));
        StringBuilder rows = new StringBuilder("theta_i,phi_i,theta_r,phi_r\n");
        for (int i = 0; i < 24; i++) {
            rows.append(3 * i + ",0," + 2 * i + ",178\n");
        }
        Files.writeString(workplace.resolve("in.csv"), rows);
        workplace.succeedHere(
                words("reflectance --patch blaze --average ensemble --directions in.csv --output out.csv " + SURFACE));

        String said = python(
                Sunbeam.repository().resolve("docs/examples/read_export.py").toString(), "b.npz", "out.csv");

        assertThat(Double.parseDouble(said.replaceAll("median ([^,]*),.*\\s*", "$1")))
                .isBetween(0.0, 0.01);
    }

    @Test
    void aSizeMakesOrdersWiderAndTheirMeanLower() throws Exception {
        workplace.succeedHere(words("export blaze --format npz --output b.npz --samples 0 --size 2MB"));

        JsonNode metadata = archived("b.npz");
        double length = metadata.path("coherence_length_metres").asDouble();
        assertThat(length).isLessThan(65e-6);
        assertThat(metadata.path("power_scale").asDouble()).isCloseTo(Math.pow(length / 65e-6, 2), offset());
        assertThat(Files.size(workplace.resolve("b.npz"))).isLessThan(2_000_000);
    }

    private static org.assertj.core.data.Offset<Double> offset() {
        return org.assertj.core.data.Offset.offset(1e-9);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "export blaze --format npz --output b.csv | --output",
                "export blaze --format npz --output b.npz --size 1B | --size 1B",
                "export blaze --format npz --output b.npz --size many | --size",
                "export blaze --format npz --output b.npz --theta-max 91 | --theta-max",
                "export blaze --format tiff --output b.npz | --format",
                "export blaze --format npz --output b.npz --channels rgb | --channels"
            })
    void whatCannotBeIsToldInALine(String commandLine, String named) throws Exception {
        Complaint.assertThatIt(workplace.here(words(commandLine)), Complaint.USAGE, named);
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aFileThatExistsStays() throws Exception {
        Files.writeString(workplace.resolve("b.npz"), "mine");

        Complaint.assertThatItExists(workplace.here(words("export none.gwy --format npz --output b.npz")), "b.npz");
        assertThat(workplace.resolve("b.npz")).hasContent("mine");
    }

    private static String[] words(String commandLine) {
        return commandLine.split(" ", -1);
    }

    private JsonNode archived(String name) throws IOException {
        try (ZipFile zip = new ZipFile(workplace.resolve(name).toFile())) {
            return new ObjectMapper().readTree(zip.getInputStream(zip.getEntry("metadata.json")));
        }
    }

    private void requireNumPy() throws Exception {
        assumeTrue(run(List.of("python3", "-c", "import numpy")) != null, "skipped: no python3 with numpy");
    }

    private String python(String... arguments) throws Exception {
        List<String> command = new java.util.ArrayList<>(List.of("python3"));
        command.addAll(List.of(arguments));
        String said = run(command);
        assertThat(said).as("%s", command).isNotNull();
        return said;
    }

    /** What a program says, or null where there is none, or it fails. */
    private String run(List<String> command) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command)
                    .directory(workplace.folder().toFile())
                    .redirectErrorStream(true)
                    .start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0 ? said : null;
        } catch (IOException absent) {
            return null;
        }
    }
}
