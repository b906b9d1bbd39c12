package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.patch.PatchSettings.COLUMNS;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT_UNIT;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** Scales of height maps, from files combined with those from settings; levels and digests of height maps. */
class HeightMapsTest {
    private static final String NUMBERS = "0 10 20 30\n40 50 60 70\n80 90 100 110\n";
    private static final String HEADER = "# Channel: Height\n# Width: 4.0 um\n# Height: 3.0 um\n# Value units: nm\n";

    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("scan.txt"), text);
    }

    private static Patch load(Path file, Object... choices) {
        Stream<Object> level = Stream.of(LEVEL, "none");
        return PatchRequests.load(
                file, Stream.concat(level, Arrays.stream(choices)).toArray());
    }

    private static Setting<?> setting(String key) {
        return PatchSettings.OF_FILES.stream()
                .filter(setting -> setting.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /** Of a file with a scale, of numbers alone, of numbers in one row and of an image. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', emptyValue = "", textBlock = """
            scale   | channel=Hight          | Setting | scan.txt, which has Height (did you mean "Height"?)
            scale   | channel=Phase          | Setting | scan.txt, which has Height
            scale   | maxHeight=2nm          | Setting | has heights in nm & overrule the unit with --height-unit
            numbers | ''                     | Input   | --width 20um and --height-unit nm
            numbers | width=4um              | Input   | in which unit its heights are; add for example --height-unit nm
            numbers | heightUnit=nm          | Input   | how large the scan is; add for example --width 20um
            row     | width=4um heightUnit=nm | Input  | --columns is missing & 12 numbers in one row
            row     | columns=5              | Setting | --columns 5 does not divide the 12 numbers
            image   | width=4um heightUnit=nm | Setting | --height-unit nm is for numbers without unit & --max-height
            """)
    void missingAndContradictingSettingsAreTold(String kind, String choices, String exception, String words)
            throws IOException {
        String numbers = kind.equals("row") ? NUMBERS.replace('\n', ' ') : NUMBERS;
        Path file = kind.equals("image")
                ? TestImages.write(TestImages.gray8(4, 4, (c, r, b) -> c), folder.resolve("grey.png"))
                : file(kind.equals("scale") ? HEADER + numbers : numbers);
        String[] parts = choices.isEmpty() ? new String[0] : choices.split("[ =]", -1);
        Object[] given = IntStream.range(0, parts.length)
                .mapToObj(i -> i % 2 == 0 ? setting(parts[i]) : parts[i])
                .toArray();
        assertThatThrownBy(() -> load(file, given))
                .hasMessageContainingAll(words.split(" & "))
                .extracting(failure -> failure.getClass().getSimpleName())
                .isEqualTo(exception + "Exception");
    }

    @ParameterizedTest
    @CsvSource({"width, 4um", "height, 0.003 mm", "heightUnit, nm"})
    void settingsMayRepeatTheFile(String key, String word) throws IOException {
        Path file = file(HEADER + NUMBERS);
        HeightMap map = load(file, setting(key), word).scan();

        assertThat(map.width()).isCloseTo(4e-6, within(1e-20));
        assertThat(map.height()).isCloseTo(3e-6, within(1e-20));
        assertThat(map.at(1, 2)).isCloseTo(90e-9, within(1e-22));
        assertThat(map.digest()).isEqualTo(load(file).scan().digest());
    }

    @Test
    void settingsOverruleTheFileWithANote() throws IOException {
        Path file = file(HEADER + NUMBERS);
        Patch wide = load(file, WIDTH, "8um");
        // The pixels keep their shape.
        assertThat(wide.scan().height()).isCloseTo(6e-6, within(1e-20));
        assertThat(wide.notes()).containsExactly("the width is 8 um as chosen, though the file says 4 um");
        Patch high = load(file, HEIGHT, "5um");
        assertThat(high.scan().width()).isCloseTo(4e-6, within(1e-20));
        assertThat(high.scan().height()).isCloseTo(5e-6, within(1e-20));
        assertThat(high.notes()).containsExactly("the height is 5 um as chosen, though the file says 3 um");
        Patch other = load(file, HEIGHT_UNIT, "pm");
        assertThat(other.scan().at(1, 2)).isCloseTo(90e-12, within(1e-25));
        assertThat(other.notes())
                .containsExactly("the heights are scaled as chosen, though the file says that they are in nm");
        Path volts = file((HEADER + NUMBERS).replace("units: nm", "units: V"));
        assertThat(load(volts, HEIGHT_UNIT, "nm").scan().at(1, 2)).isCloseTo(90e-9, within(1e-22));
    }

    @Test
    void thousandsAreToldByTheNameThatTheUserKnows() throws IOException {
        file("# Width: 8 um\n# Value units: nm\n1,000.0 1,011.1 \n1,022.2 1,033.3 \n");
        assertThatThrownBy(() -> load(folder.resolve("scan.txt")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("or give --decimal-mark point");
        Path descriptor = Files.writeString(folder.resolve("scan.json"), "{\"heights\": \"scan.txt\"}");
        assertThatThrownBy(() -> PatchRequests.load(descriptor))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("or give decimalMark point")
                .hasMessageNotContaining("--");
    }

    @Test
    void aProfileIsToldAndReadAsASurface() throws IOException {
        String rows = IntStream.range(0, 64)
                .mapToObj(i -> 0.25 * i + " " + 50 * Math.sin(i) + "\n")
                .collect(Collectors.joining());
        Patch profile = load(file(rows), WIDTH, "16um", HEIGHT_UNIT, "nm");

        assertThat(profile.scan().width()).isCloseTo(16e-6, within(1e-20));
        assertThat(profile.scan().height()).isCloseTo(16e-6, within(1e-18));
        assertThat(profile.notes())
                .containsExactly("a profile of 64 heights: the surface is taken as constant along y");
    }

    /** The aperture of an interferometer. */
    @Test
    void aSurfaceOfDecimetersIsRead() throws IOException {
        String large = HEADER.replace("4.0 um", "151 mm").replace("3.0 um", "113 mm");
        assertThat(load(file(large + NUMBERS)).scan().width()).isCloseTo(0.151, within(1e-15));
    }

    @Test
    void faultsOfAFileNameNoOption() throws IOException {
        Path tiny = file((HEADER + NUMBERS).replace("4.0 um", "4.0 fm").replace("3.0 um", "3.0 fm"));
        assertThatThrownBy(() -> load(tiny))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("scan.txt claims to be 0.004 pm")
                .hasMessageNotContaining("--width");
        Path volts = file((HEADER + NUMBERS).replace("units: nm", "units: V"));
        assertThatThrownBy(() -> load(volts))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("holds no heights: none of its channels has a unit of length")
                .hasMessageNotContaining("--channel");
    }

    @Test
    void numbersInOneRowNeedTheirColumns() throws IOException {
        Path file = file(NUMBERS.replace('\n', ' '));
        HeightMap map =
                load(file, WIDTH, "4um", HEIGHT_UNIT, "nm", COLUMNS, "4").heights();
        assertThat(map.rows()).isEqualTo(3);
        assertThat(map.at(1, 2)).isCloseTo(90e-9, within(1e-22));
    }

    @Test
    void aFloatImageHasAUnitOrAFullScale() throws IOException {
        Path file =
                TestImages.write(TestImages.gray32f(4, 4, (c, r, b) -> 534e-9 * c / 3), folder.resolve("metres.tiff"));

        assertThatThrownBy(() -> load(file, WIDTH, "4um", MAX_HEIGHT, "534nm"))
                .isInstanceOf(SettingException.class)
                .hasMessageContainingAll(
                        "--max-height 534 nm makes a relief of 0.285156 pm",
                        "less than a hundredth of an atom; check both units");
        HeightMap map = load(file, WIDTH, "4um", HEIGHT_UNIT, "m").scan();
        // Seven digits of a float.
        assertThat(map.relief()).isCloseTo(534e-9, within(5e-14));
    }

    @Test
    void imagesHaveSquarePixelsUnlessTheHeightIsGiven() throws IOException {
        Path file = TestImages.write(TestImages.gray8(8, 4, (c, r, b) -> c == 7 ? 255 : 0), folder.resolve("grey.png"));
        Object[] scale = {WIDTH, "8um", MAX_HEIGHT, "375nm"};
        HeightMap square = load(file, scale).scan();
        HeightMap oblong =
                load(file, scale[0], "8um", scale[2], "375nm", HEIGHT, "8um").scan();

        // Two roundings: of full scale and of the product.
        assertThat(square.relief() / 375e-9 - 1).isBetween(-3e-16, 3e-16);
        assertThat(square.pitchY()).isEqualTo(1e-6);
        assertThat(oblong.pitchY()).isEqualTo(2e-6);
    }

    @ParameterizedTest
    @CsvSource({
        "2.5um, 5um, relief of 5 um is larger than the patch (2.5 um)",
        "20mm, 5um, the scan is 20 mm wide",
        "65um, 20um, one gray level is 78.4314 nm"
    })
    void warnsOfScalesThatHardlyAre(String width, String maxHeight, String warning) throws IOException {
        Path file = TestImages.write(TestImages.gray8(64, 64, (c, r, b) -> 4 * c + r % 4), folder.resolve("grey.png"));

        assertThat(load(file, WIDTH, width, MAX_HEIGHT, maxHeight).warnings()).anyMatch(line -> line.contains(warning));
    }

    /** Counts of 1 pm in 32 bits have a full scale of 4.3 mm; here 0 to 3 of 65535 are 183 nm. */
    @Test
    void theReliefCountsNotTheFullScale() throws IOException {
        Path file = TestImages.write(TestImages.gray16(4, 4, (c, r, b) -> c), folder.resolve("few.png"));

        // Two roundings.
        assertThat(load(file, WIDTH, "4um", MAX_HEIGHT, "4mm").scan().relief())
                .isCloseTo(3 * 4e-3 / 65_535, within(1e-20));
        assertThatThrownBy(() -> load(file, WIDTH, "4um", MAX_HEIGHT, "400mm"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--max-height 400 mm makes a relief of 18.3108 um");
    }

    private static final int SIDE = 40;

    /** Asserts that the levels are the sorted distinct heights and that each sample's index finds its height; returns the levels. */
    private static HeightMap assertSortedDistinctAndIndexed(IntToDoubleFunction heights) {
        double[] samples = new double[SIDE * SIDE];
        Arrays.setAll(samples, heights);
        HeightMap levels = new HeightMap(SIDE, SIDE, 1e-8, 1e-8, samples);

        assertThat(levels.levels())
                .containsExactly(Arrays.stream(samples)
                        .map(h -> h + 0.0)
                        .sorted()
                        .distinct()
                        .toArray());
        for (int i = 0; i < samples.length; i++) {
            assertThat(levels.levels()[levels.index()[i]]).isEqualTo(samples[i] + 0.0);
        }
        return levels;
    }

    @Test
    void everySampleHasItsLevelAndMinusZeroIsZero() {
        Random random = new Random(4);
        assertSortedDistinctAndIndexed(i -> 1e-7 * random.nextGaussian());
        HeightMap bytes = assertSortedDistinctAndIndexed(i -> 1e-9 * random.nextInt(256));
        assertThat(bytes.levels().length).isBetween(250, 256);
        HeightMap flat = assertSortedDistinctAndIndexed(i -> 3e-9);
        assertThat(flat.levels().length).isEqualTo(1);
        HeightMap zeros = assertSortedDistinctAndIndexed(i -> i % 3 == 0 ? -0.0 : i % 3 == 1 ? 0.0 : Double.MIN_VALUE);
        assertThat(zeros.levels().length).isEqualTo(2);
    }

    @Test
    void aGrainOfDustDoesNotMixUpTheRest() {
        Random random = new Random(5);
        // All levels but one lie in one step of the search.
        assertSortedDistinctAndIndexed(i -> i == 77 ? 1e-3 : 1e-12 * random.nextInt(500));
        assertSortedDistinctAndIndexed(i -> i == 77 ? -Double.MAX_VALUE : i == 78 ? Double.MAX_VALUE : i);
    }

    /** The decision is based on 8192 samples; 4096 levels of a scan are not many, rare levels are. */
    @Test
    void estimatesWhetherLevelsAreMany() {
        Random random = new Random(6);
        int side = 300;
        double[] samples = new double[side * side];
        for (int levels : new int[] {1, 2, 256, 4096, 10_000}) {
            Arrays.setAll(samples, i -> 1e-9 * random.nextInt(levels));
            HeightMap few = new HeightMap(side, side, 1e-8, 1e-8, samples.clone());
            assertThat(few.hasTooManyLevels()).as("%d levels", levels).isFalse();
        }
        Arrays.setAll(samples, i -> random.nextGaussian());
        assertThat(new HeightMap(side, side, 1e-8, 1e-8, samples).hasTooManyLevels())
                .isTrue();
    }

    @Test
    void theDigestIsTheSha256OfTheDocumentedLayout() throws Exception {
        double[] heights = new Random(6).doubles(200 * 90).toArray();
        ByteBuffer layout = ByteBuffer.allocate(21 + 24 + 8 * heights.length);
        layout.put("sunbeam height map 1\n".getBytes(StandardCharsets.US_ASCII));
        layout.putInt(200).putInt(90).putDouble(1e-9).putDouble(2e-9);
        for (double height : heights) {
            layout.putDouble(height);
        }
        String expected =
                HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(layout.array()));

        assertThat(new HeightMap(200, 90, 1e-9, 2e-9, heights).digest()).isEqualTo(expected);
    }
}
