package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipFile;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.Srgb;

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

    private static Offset<Double> offset() {
        return Offset.offset(1e-9);
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
                "export blaze --format npz --output b.npz --channels rgb | --channels",
                "export blaze --format html --output b.html --channels rec709 | --channels",
                "export blaze --format html --output b.html --size 1kB | --size 1kB"
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

    @Test
    void aPageDrawsTheMapThatBrdfMapDraws() throws Exception {
        requireChromium();
        workplace.succeedHere(words("export blaze --format html --output b.html --samples 0 --coherence-length 16um"));
        String page = Files.readString(workplace.resolve("b.html"));
        JsonNode table = new ObjectMapper().readTree(between(page, "id=\"table\">", "</script>"));
        workplace.succeedHere(
                words("brdf-map --patch blaze --theta-i 30 --size 400 --tolerance 0.01 --no-annotate --output map.png"
                        + " --exposure " + table.path("exposure").asText() + " --coherence-length 16um"));

        chromium("--window-size=800,400", "--screenshot=page.png", url("b.html#bare&theta=30"));

        List<Double> differences = differences("map.png", "page.png");
        assertThat(differences).as("places with light").hasSizeGreaterThan(1000);
        assertThat(differences.get(differences.size() / 2))
                .as("median CIEDE2000")
                .isLessThan(1);
        assertThat(differences.get(differences.size() * 9 / 10))
                .as("90th percentile")
                .isLessThan(4);
        assertThat(page.length()).isLessThan(1_000_000);
        assertThat(page).doesNotContain("http").contains("coherence length of 16 um");
    }

    @Test
    void aBrowserWithoutWebGlIsToldSo() throws Exception {
        requireChromium();
        workplace.succeedHere(words("export blaze --format html --output b.html --samples 0 --size 200kB"));

        assertThat(chromium("--disable-3d-apis", "--dump-dom", url("b.html"))).contains("has no WebGL 2");
    }

    private static String between(String text, String before, String after) {
        int from = text.indexOf(before) + before.length();
        return text.substring(from, text.indexOf(after, from));
    }

    /** CIEDE2000 in the square of the map, in ascending order, where that has light. */
    private List<Double> differences(String map, String page) throws IOException {
        BufferedImage one = ImageIO.read(workplace.resolve(map).toFile());
        BufferedImage other = ImageIO.read(workplace.resolve(page).toFile());
        List<Double> differences = new ArrayList<>();
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                CieLab lab = lab(one.getRGB(x, y));
                if (lab.lightness() > 1) {
                    differences.add(ColorDifference.ciede2000(lab, lab(other.getRGB(x, y))));
                }
            }
        }
        Collections.sort(differences);
        return differences;
    }

    private static CieLab lab(int rgb) {
        double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16 & 0xff), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
        return CieLab.ofXyz(xyz[0], xyz[1], xyz[2]);
    }

    private String url(String name) {
        return workplace.folder().toUri() + name;
    }

    private void requireChromium() throws Exception {
        assumeTrue(run(List.of("chromium", "--version")) != null, "skipped: no chromium");
    }

    /** Time stands still in the page until it has drawn. */
    private String chromium(String... arguments) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                "chromium",
                "--headless",
                "--no-sandbox",
                "--user-data-dir=" + root.resolve("browser"),
                "--use-gl=angle",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--hide-scrollbars",
                "--virtual-time-budget=20000"));
        command.addAll(List.of(arguments));
        String said = run(command);
        assertThat(said).as("%s", command).isNotNull();
        return said;
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
        List<String> command = new ArrayList<>(List.of("python3"));
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
