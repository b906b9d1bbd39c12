package sunbeam.precompute.scan.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/** Files whose headers claim more than they contain are refused. */
class HostileScansTest {
    @TempDir
    Path folder;

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

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    @Test
    void aHeaderCannotAskForMoreThanTheFileHas() throws IOException {
        String huge = new String(TestScans.file("gsf"), StandardCharsets.ISO_8859_1);
        assertRefused(
                huge.replace("XRes = 7", "XRes = 9").getBytes(StandardCharsets.ISO_8859_1),
                "ends after",
                "copy or export");
        assertRefused(huge.replace("XRes = 7", "XRes = 99999999999").getBytes(StandardCharsets.ISO_8859_1), "XRes");
    }

    @Test
    void aTextOfTooManyNumbersIsRefusedByItsCount() throws IOException {
        // 20000 numbers in each of two rows.
        assertRefused(ascii("1 ".repeat(20_000) + "\n" + "2 ".repeat(20_000) + "\n"), "20000 x 2 samples", "crop");
    }

    @Test
    void aTextWithRaggedRowsIsRefusedByTheLine() throws IOException {
        assertRefused(ascii("1 2 3\n4 5 6\n7 8\n"), "2 numbers in line 3, but 3 in its first row");
        assertRefused(ascii("1 2 3\n4 x 6\n"), "\"x\" in line 2");
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
        StringBuilder points = new StringBuilder();
        for (int i = 0; i < 40; i++) {
            points.append("%d %d %d\n".formatted(i * i % 37, i * 17 % 41, i));
        }
        assertRefused(ascii(points.toString()), "no points of a grid");
        assertRefused(ascii("0 0 1\n1 0 1\n0 1 1\n1 1 1\n1 1 2\n"), "two points");
    }
}
