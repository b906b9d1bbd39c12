package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.sun.net.httpserver.HttpServer;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.NpyImage.NpzFile;
import sunbeam.precompute.color.CieLab;

/** Exported tables, read by other programs, hold the values of {@code reflectance}. */
class ExportTest extends InOneWorkplace {
    private static final String SURFACE = "--coherence-length 16um";

    @BeforeAll
    static void export() throws IOException {
        workplace.succeedHere("export blaze --format npz --output b.npz --samples 4 --tolerance 0.01 " + SURFACE);
        workplace.succeedHere("export blaze --format html --output b.html --samples 0 " + SURFACE);
        workplace.succeedHere("export blaze --format glsl --output b --samples 0 " + SURFACE);
    }

    @Test
    void anArchiveSaysWhatItHoldsAndHowFarItIsFromTheReference() throws Exception {
        JsonNode metadata = NpzFile.read(workplace.resolve("b.npz")).metadata();
        assertThat(metadata.path("patch").asText()).isEqualTo("blaze");
        assertThat(metadata.path("coherence_length_m").asDouble()).isCloseTo(16e-6, within(1e-9));
        assertThat(metadata.path("power_scale").asDouble()).isEqualTo(1);
        assertThat(metadata.path("axes")).hasSize(3);
        JsonNode error = metadata.path("error").path("beside_reference");
        assertThat(error.path("count").asInt()).isEqualTo(4);
        assertThat(error.path("median").asDouble()).isBetween(0.0, 0.05);
    }

    @Test
    void numPyReadsTheColorsThatReflectanceTells() throws Exception {
        OtherPrograms.requirePython("numpy");
        List<double[]> rows = IntStream.range(0, 24)
                .mapToObj(i -> new double[] {3 * i, 0, 2 * i, 178})
                .toList();
        workplace.reflectance("blaze", CsvFile.ofDirections(rows), "--average ensemble " + SURFACE);

        String said =
                OtherPrograms.python(workplace.folder(), Sunbeam.example("read_export.py"), "b.npz", "reflectance.csv");

        assertThat(Double.parseDouble(said.replaceAll("median ([^,]*),.*\\s*", "$1")))
                .isBetween(0.0, 0.01);
    }

    @Test
    void aFolderNamesAnExposure() throws IOException {
        JsonNode metadata =
                new ObjectMapper().readTree(workplace.resolve("b/sunbeam.json").toFile());
        double exposure = metadata.path("exposure").asDouble();
        assertThat(metadata.path("exposure_theta_i_deg").asDouble()).isEqualTo(30);
        assertThat(Files.readString(workplace.resolve("b/sunbeam.html"))).contains("" + (float) exposure);
        assertThat(Files.readString(workplace.resolve("b/sunbeam.md")))
                .contains(
                        String.format(Locale.ROOT, "%.3g is that of `brdf-map` under light at 30.0 degrees", exposure));
    }

    /** Without --samples one compares what a tenth of the table's time allows, and says how many pairs that are. */
    @Test
    void errorsAreOfAsManyPairsAsTheOutputSays() throws Exception {
        SunbeamResult made =
                workplace.here("export sinusoid --format npz --output e.npz --coherence-length 4um --size 1MB");

        JsonNode error = NpzFile.read(workplace.resolve("e.npz")).metadata().path("error");
        int sums = error.path("beside_sums_over_wavelengths").path("count").asInt();
        assertThat(sums).isBetween(1, 1000);
        assertThat(made.stderr()).startsWith("plan: table: ").contains("a table of at most 1.0 MB");
        assertThat(made.stdout()).contains("beside sums over wavelengths at " + sums + " pairs");
    }

    @Test
    void aSizeMakesOrdersWiderAndTheirMeanLower() throws Exception {
        workplace.succeedHere("export blaze --format npz --output small.npz --samples 0 --size 2MB");

        JsonNode metadata = NpzFile.read(workplace.resolve("small.npz")).metadata();
        double length = metadata.path("coherence_length_m").asDouble();
        assertThat(length).isLessThan(65e-6);
        assertThat(metadata.path("power_scale").asDouble()).isCloseTo(Math.pow(length / 65e-6, 2), within(1e-9));
        assertThat(Files.size(workplace.resolve("small.npz"))).isLessThan(2_000_000);
    }

    @Test
    void aPageDrawsTheMapThatBrdfMapDraws() throws Exception {
        OtherPrograms.requireChromium();
        String page = Files.readString(workplace.resolve("b.html"));
        JsonNode table = new ObjectMapper().readTree(page.replaceAll("(?s).* id=\"table\">(.*?)</script>.*", "$1"));
        workplace.succeedHere(
                "brdf-map --patch blaze --theta-i 30 --size 400 --tolerance 0.01 --no-annotate --output map.png"
                        + " --exposure %s --coherence-length 16um",
                table.path("exposure").asText());

        OtherPrograms.chromium(
                workplace.folder(), "--window-size=800,400", "--screenshot=page.png", url("b.html#bare&theta=30"));

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
    void aNarrowScreenStacksThePictures() throws Exception {
        OtherPrograms.requireChromium();

        String page = OtherPrograms.chromium(workplace.folder(), "--window-size=520,900", "--dump-dom", url("b.html"));

        // The rims of map and sphere have one middle; the page begins with the verdict and ends with its errors.
        assertThat(page)
                .containsPattern("<circle cx=\"([0-9.]+)\" [^>]*></circle>.*<circle cx=\"\\1\"")
                .containsPattern(
                        "(?s)<h1>A repeated patch with a period of 2.5 um.*<canvas.*class=\"bar\".*beside sums")
                .contains("coherence length of 16 um: an order is");
    }

    @Test
    void aBrowserWithoutWebGlIsToldSo() throws Exception {
        OtherPrograms.requireChromium();

        assertThat(OtherPrograms.chromium(workplace.folder(), "--disable-3d-apis", "--dump-dom", url("b.html")))
                .contains("has no WebGL 2");
    }

    @ParameterizedTest
    @CsvSource({"glsl, vec3 sunbeam(vec3 wi", "hlsl, float3 sunbeam(Texture2DArray", "wgsl, fn sunbeam(sunbeamTable"})
    void aFolderForEnginesHasTheFunctionInEachLanguage(String ending, String declaration) {
        assertThat(workplace.resolve("b/sunbeam." + ending))
                .content()
                .contains(declaration)
                .doesNotContainPattern("@[A-Z_]+@");
        assertThat(workplace.resolve("b/sunbeam.md"))
                .content()
                .contains("sunbeam." + ending)
                .doesNotContainPattern("@[A-Z_]+@");
    }

    /** Reads KTX 2.0 by its specification: a coarser level is the mean of the finest. */
    @Test
    void aTextureHasLevelsOfWiderOrders() throws Exception {
        assertThat(workplace.resolve("b")).isDirectoryContaining("glob:**/sunbeam.glsl");
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(workplace.resolve("b/sunbeam.ktx2")))
                .order(ByteOrder.LITTLE_ENDIAN);
        assertThat(file.getInt(12)).as("VK_FORMAT_R16G16B16A16_SFLOAT").isEqualTo(97);
        assertThat(file.getInt(40)).as("levels").isGreaterThan(1);
        int texels = file.getInt(20) * file.getInt(24) * file.getInt(32);
        double[] finest = meanSquares(file, 0, texels);
        double[] coarser = meanSquares(file, 1, texels / 4);
        for (int c = 0; c < 3; c++) {
            assertThat(coarser[c]).isCloseTo(finest[c], within(0.02 * finest[c]));
        }
        JsonNode metadata = workplace.readJson("b/sunbeam.json");
        assertThat(metadata.path("axes").path(2).path("count").asInt()).isEqualTo(file.getInt(20));
        assertThat(metadata.path("error")
                        .path("beside_sums_over_wavelengths")
                        .path("median")
                        .asDouble())
                .isBetween(0.0, 0.05);
    }

    private static double[] meanSquares(ByteBuffer file, int level, int texels) {
        int at = (int) file.getLong(80 + 24 * level);
        assertThat(file.getLong(88 + 24 * level)).isEqualTo(8L * texels);
        double[] means = new double[3];
        for (int i = 0; i < texels; i++) {
            for (int c = 0; c < 3; c++) {
                int half = file.getShort(at + 8 * i + 2 * c);
                int exponent = half >> 10;
                double value = exponent == 0 ? half * 0x1p-24 : (1024 + (half & 1023)) * Math.pow(2, exponent - 25.0);
                means[c] += value * value / texels;
            }
        }
        return means;
    }

    @Test
    void openExrReadsTheSlices() throws Exception {
        OtherPrograms.requirePython("OpenEXR");

        String said = OtherPrograms.python(
                workplace.folder(),
                "-c",
                "import OpenEXR; part = OpenEXR.File('b/sunbeam.exr').parts[0];"
                        + " pixels = part.channels['RGB'].pixels; print(*pixels.shape, pixels.max())");

        JsonNode axes = workplace.readJson("b/sunbeam.json").path("axes");
        String[] shape = said.strip().split(" ", -1);
        assertThat(Integer.parseInt(shape[0]))
                .isEqualTo(axes.path(0).path("count").asInt()
                        * axes.path(1).path("count").asInt());
        assertThat(Integer.parseInt(shape[1]))
                .isEqualTo(axes.path(2).path("count").asInt());
        assertThat(Double.parseDouble(shape[3])).isBetween(1.0, 268.0);
    }

    @Test
    void openExrReadsALinearMapAsNumPyDoes() throws Exception {
        OtherPrograms.requirePython("OpenEXR, numpy");
        for (String file : List.of("map.exr", "map.npy")) {
            workplace.here("brdf-map --patch blaze --size 33 --force --output map.png --linear " + file);
        }

        String said = OtherPrograms.python(
                workplace.folder(),
                "-c",
                "import OpenEXR, numpy as np; rgba = OpenEXR.File('map.exr').parts[0].channels['RGBA'].pixels;"
                        + " xyz = np.load('map.npy'); seen = ~np.isnan(xyz[..., 1]);"
                        + " y = rgba[..., :3] @ [0.2126729, 0.7151522, 0.0721750];"
                        + " print(np.abs(y - xyz[..., 1])[seen].max() / xyz[seen].max(), (rgba[..., 3] == seen).all())");

        String[] parts = said.strip().split(" ", -1);
        // Rounding of float32 and of the matrices' seven digits.
        assertThat(Double.parseDouble(parts[0])).isLessThan(1e-6);
        assertThat(parts[1]).isEqualTo("True");
    }

    @Test
    void aPageUsesTheFunctionAndTheTexture() throws Exception {
        OtherPrograms.requireChromium();
        HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", exchange -> {
            byte[] bytes = Files.readAllBytes(
                    workplace.resolve("b" + exchange.getRequestURI().getPath()));
            exchange.sendResponseHeaders(200, bytes.length);
            exchange.getResponseBody().write(bytes);
            exchange.close();
        });
        server.start();
        try {
            OtherPrograms.chromium(
                    workplace.folder(),
                    "--window-size=640,640",
                    "--screenshot=sphere.png",
                    "http://127.0.0.1:" + server.getAddress().getPort() + "/sunbeam.html");
        } finally {
            server.stop(0);
        }

        BufferedImage sphere = ImageIO.read(workplace.resolve("sphere.png").toFile());
        int colored = 0;
        for (int x = 8; x < 608; x++) {
            int rgb = sphere.getRGB(x, 308);
            colored += Math.abs((rgb >> 16 & 0xff) - (rgb & 0xff)) > 40 ? 1 : 0;
        }
        assertThat(colored).as("colored places along the orders").isBetween(10, 500);
    }

    /** Returns CIEDE2000 of the map's lit pixels, ascending. */
    private List<Double> differences(String map, String page) throws IOException {
        BufferedImage one = ImageIO.read(workplace.resolve(map).toFile());
        BufferedImage other = ImageIO.read(workplace.resolve(page).toFile());
        List<Double> differences = new ArrayList<>();
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                CieLab lab = CieLab.ofSrgb(one.getRGB(x, y));
                if (lab.lightness() > 1) {
                    differences.add(lab.difference(CieLab.ofSrgb(other.getRGB(x, y))));
                }
            }
        }
        Collections.sort(differences);
        return differences;
    }

    private String url(String name) {
        return workplace.folder().toUri() + name;
    }
}
