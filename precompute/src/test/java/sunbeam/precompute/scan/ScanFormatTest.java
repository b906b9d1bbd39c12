package sunbeam.precompute.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** All formats give the same surface, and misleading files a complaint only. */
class ScanFormatTest {
    /** Seven digits of 500 nm, as 32-bit floats have. */
    private static final double ROUNDING = 5e-14;

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "gwy",
                "gsf",
                "gwyddion-text",
                "gwyddion-text-german",
                "spip-text",
                "points",
                // Samples of the last have 32 bits, while the header gives the number of steps of 16 bits.
                "nanoscope",
                "nanoscope-32",
                "nanoscope-32-of-16",
                "ibw",
                "nid",
                "stp",
                "top",
                "jpk",
                "jpk-qi-image",
                "park",
                "sdf-text",
                "sdf-binary",
                "x3p",
                "sur",
                "mi",
                // Gwyddion 2.62 and SurfaceTopography 1.27.1 read the following alike, except for the text of Wyko.
                "opd",
                "opd-16",
                "wyko-text",
                "metropro",
                "plu",
                "al3d",
                "bcrf",
                "bcrf-utf-16",
                "bcr",
                "vk4"
            })
    void readsTheHeightsTheirSizeAndWhichWayIsUp(String format) throws IOException {
        // No extension: formats are found by content.
        try (ScanBytes bytes = ScanBytes.open(Files.write(folder.resolve("scan"), TestScans.file(format)))) {
            ChannelList channels = TestScans.channels(bytes);
            ScanChannel channel = channels.channels().get(channels.heights().orElseThrow());

            assertThat(channel.columns()).isEqualTo(TestScans.COLUMNS);
            assertThat(channel.rows()).isEqualTo(TestScans.ROWS);
            assertThat(channel.extent().width().orElseThrow()).isCloseTo(TestScans.WIDTH, within(1e-6 * 1e-6));
            // MetroPro has one pitch for both axes, Keyence no heights below 0.
            double height = format.equals("metropro") ? 2.5e-6 : TestScans.HEIGHT;
            double lift = format.equals("vk4") ? 200e-9 : 0;
            assertThat(channel.extent().height().orElseThrow()).isCloseTo(height, within(1e-6 * 1e-6));
            double meters = channel.metersPerUnit().orElseThrow();
            assertThat(Arrays.stream(channel.samples().read())
                            .map(s -> s * meters - lift)
                            .toArray())
                    .containsExactly(TestScans.meters(), within(ROUNDING));
        }
    }

    /** Little-endian or, for MetroPro, big-endian marks; bytes after the last sample. */
    @ParameterizedTest
    @CsvSource({
        "opd, 0x7f61b1e6, 0",
        "opd-16, 0x7fff, 0",
        "metropro, 0xf8ffff7f, 0",
        "plu, 0x49742410, 8",
        "al3d, 0x7fc00000, 4",
        "bcrf, 0x7f7fffff, 0",
        "bcr, 0xff7f, 0"
    })
    void marksOfMissingSamplesAreKnown(String format, String mark, int after) throws IOException {
        byte[] content = TestScans.file(format);
        long bits = Long.decode(mark);
        int bytes = (mark.length() - 2) / 2;
        for (int i = 0; i < bytes; i++) {
            content[content.length - after - bytes + i] = (byte) (bits >> (8 * i));
        }
        try (ScanBytes file = ScanBytes.open(Files.write(folder.resolve("scan"), content))) {
            double[] samples =
                    TestScans.channels(file).channels().get(0).samples().read();
            // Wyko's last sample is the top one of the last column.
            int last = format.startsWith("opd") ? TestScans.COLUMNS - 1 : samples.length - 1;
            for (int i = 0; i < samples.length; i++) {
                assertThat(Double.isNaN(samples[i])).as("%d", i).isEqualTo(i == last);
            }
        }
    }

    private void assertRefused(byte[] content, String... complaints) throws IOException {
        Path file = Files.write(folder.resolve("scan"), content);
        assertThatThrownBy(() -> {
                    try (ScanBytes bytes = ScanBytes.open(file)) {
                        for (ScanChannel channel : TestScans.channels(bytes).channels()) {
                            channel.samples().read();
                        }
                    }
                })
                .isInstanceOf(ScanException.class)
                .satisfies(e -> assertThat(e.getMessage()).contains(complaints).doesNotContain("\n"));
    }

    private static byte[] zip(String xml, byte[] samples) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            zip.putNextEntry(new ZipEntry("bindata/data.bin"));
            zip.write(samples);
            zip.putNextEntry(new ZipEntry("main.xml"));
            zip.write(xml.getBytes(StandardCharsets.UTF_8));
        }
        return bytes.toByteArray();
    }

    private static byte[] latin1(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    @Test
    void aSimpleFieldIsRefusedIfItsSizeOrItsHeaderContradictsItself() throws IOException {
        String header = "Gwyddion Simple Field 1.0\nXRes = 3\nYRes = 2\nXReal = 1e-5\nYReal = 1e-5\nXYUnits = m\n";
        assertRefused(simpleField(header, 7), "announces 3 x 2 samples of 4 bytes", "has 28 bytes");
        assertRefused(simpleField(header + "XReal = 2e-5\n", 6), "several values for \"XReal\"");
    }

    private static byte[] simpleField(String header, int samples) {
        int start = 4 * (header.length() / 4 + 1);
        return Arrays.copyOf(header.getBytes(StandardCharsets.US_ASCII), start + Float.BYTES * samples);
    }

    @Test
    void aHeaderCannotAskForMoreThanTheFileHas() throws IOException {
        String field = new String(TestScans.file("gsf"), StandardCharsets.ISO_8859_1);
        assertRefused(latin1(field.replace("XRes = 7", "XRes = 9")), "ends after", "copy or export");
        assertRefused(latin1(field.replace("XRes = 7", "XRes = 99999999999")), "XRes");
    }

    @Test
    void aTextOfTooManyNumbersIsRefusedByItsCount() throws IOException {
        // 20000 numbers in each of two rows.
        assertRefused(latin1("1 ".repeat(20_000) + "\n" + "2 ".repeat(20_000) + "\n"), "20000 x 2 samples", "crop");
    }

    @Test
    void aTextWithRaggedRowsIsRefusedByTheLine() throws IOException {
        assertRefused(latin1("1 2 3\n4 5 6\n7 8\n"), "2 numbers in line 3, but 3 in its first row");
        assertRefused(latin1("1 2 3\n4 x 6\n"), "\"x\" in line 2");
    }

    @Test
    void thousandsOfChannelsAreRefused() throws IOException {
        byte[] wave = TestScans.file("ibw");
        ByteBuffer.wrap(wave).order(ByteOrder.LITTLE_ENDIAN).putInt(64 + 76, 5000);
        int sum = 0;
        for (int i = 4; i < 384; i += 2) {
            sum += (wave[i] & 0xff) | (wave[i + 1] << 8);
        }
        ByteBuffer.wrap(wave).order(ByteOrder.LITTLE_ENDIAN).putShort(2, (short) (-sum - 5));
        assertRefused(wave, "5000 channels", "at most 256");
    }

    @Test
    void pagesInACircleAreReadOnce() throws IOException {
        byte[] tiff = TestScans.file("jpk");
        ByteBuffer bytes = ByteBuffer.wrap(tiff).order(ByteOrder.BIG_ENDIAN);
        int tags = bytes.getShort(8);
        bytes.putInt(8 + 2 + 12 * tags, 8);
        assertRefused(tiff, "holds no channel");
    }

    private static ByteBuffer tiff(int directories, int next) {
        ByteBuffer tiff = ByteBuffer.allocate(8 + 18 * directories).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(8);
        for (int i = 1; i <= directories; i++) {
            int following = i == directories ? 0 : 8 + 18 * i;
            // One tag, then the next directory: as the next page, or nested in the tag.
            tiff.putShort((short) 1)
                    .putShort((short) (next == 0 ? 256 : next))
                    .putShort((short) 4)
                    .putInt(1);
            tiff.putInt(next == 0 ? 1 : following).putInt(next == 0 ? following : 0);
        }
        return tiff;
    }

    @Test
    void pagesAreCountedBeforeTheyAreRead() throws IOException {
        assertRefused(tiff(200_000, 0).array(), "claims 257 channels; at most 256");
    }

    @Test
    void directoriesThatNestWithoutEndAreRefused() throws IOException {
        assertRefused(tiff(20_000, 330).array(), "damaged TIFF, or of a kind that cannot be read");
    }

    @Test
    void anArchiveThatUnpacksToFarMoreIsNotUnpacked() throws IOException {
        // 64 MB of blanks take 64 KB in the archive.
        String xml = "<?xml version=\"1.0\"?><p>" + " ".repeat(1 << 26) + "</p>";
        assertRefused(zip(xml, new byte[4]), "longer than 1 MB");
    }

    @Test
    void archivesCannotNameFilesOutside() throws IOException {
        String xml = "<?xml version=\"1.0\"?><!DOCTYPE p [<!ENTITY e SYSTEM \"file:///etc/hostname\">]><p>&e;</p>";
        assertRefused(zip(xml, new byte[4]), "export it again");
        String outside = "<p><Axes><CX><Increment>1e-7</Increment></CX><CY><Increment>1e-7</Increment></CY>"
                + "<CZ><DataType>D</DataType></CZ></Axes><MatrixDimension><SizeX>2</SizeX><SizeY>2</SizeY></MatrixDimension>"
                + "<DataLink><PointDataLink>../../etc/passwd</PointDataLink></DataLink></p>";
        assertRefused(zip(outside, new byte[32]), "no bytes of ../../etc/passwd, where its matrix takes 32");
    }

    @Test
    void pointsOnNoGridAreRefused() throws IOException {
        String points = IntStream.range(0, 40)
                .mapToObj(i -> "%d %d %d\n".formatted(i * i % 37, i * 17 % 41, i))
                .collect(Collectors.joining());
        assertRefused(latin1(points), "no points of a grid");
        assertRefused(latin1("0 0 1\n1 0 1\n0 1 1\n1 1 1\n1 1 2\n"), "two points");
    }

    /** The bits of 1, -2, 2^-24 (the smallest), 65504 (the largest), infinity and NaN. */
    private static final short[] HALVES = {0x3c00, (short) 0xc000, 0x0001, 0x7bff, 0x7c00, 0x7e00};

    private Path numpyFile(String type, String shape) throws IOException {
        byte[] header = latin1("{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n");
        ByteBuffer numpyFile = ByteBuffer.allocate(10 + header.length + 2 * HALVES.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(latin1("\u0093NUMPY\u0001\u0000"))
                .putShort((short) header.length)
                .put(header)
                .order(type.startsWith(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        for (short half : HALVES) {
            numpyFile.putShort(half);
        }
        return Files.write(folder.resolve("scan.npy"), numpyFile.array());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
            f8 | (9999999999, 128) | has 128 x 9999999999 samples; at most
            u8 | (2, 3)            | numbers of type u8, which is not read; save a.astype('float64')
            """)
    void namesTheRemedy(String type, String shape, String complaint) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(numpyFile("<" + type, shape))) {
            assertThatThrownBy(() -> BinaryHeaderReaders.numpy(bytes)).hasMessageContaining(complaint);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"<", ">"})
    void readsHalfFloats(String order) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(numpyFile(order + "f2", "(2, 3)"))) {
            assertThat(BinaryHeaderReaders.numpy(bytes).get(0).samples().read())
                    .containsExactly(1, -2, Math.pow(2, -24), 65504, Double.POSITIVE_INFINITY, Double.NaN);
        }
    }
}
