package sunbeam.precompute.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sides, lines and units in headers of Bruker scans. */
class NanoscopeHeaderTest {
    private static final int HEADER = 2048;
    private static final int COLUMNS = 8;
    private static final int LINES = 4;

    private static final String TEXT = """
            \\*File list
            \\Version: 0x05310001
            \\*Ciao scan list
            \\Scan Size: 10 um
            \\Lines: 4
            \\@Sens. ZsensSens: V 10.0 nm/V
            \\*Ciao image list
            \\Data offset: 2048
            \\Data length: 64
            \\Bytes/pixel: 2
            \\Samps/line: 8
            \\Number of lines: 4
            \\Aspect Ratio: 1:1
            \\Scan Size: 10 10 ~m
            \\Valid data len Y: 4
            \\@2:Image Data: S [ZSensor] "Height Sensor"
            \\@2:Z scale: V [Sens. ZsensSens] (0.0003750000 V/LSB) 65.536 V
            \\*File list end
            """;

    private static final String MODULUS = """
            \\*Ciao image list
            \\Data offset: 2048
            \\Data length: 64
            \\Bytes/pixel: 2
            \\Samps/line: 8
            \\Number of lines: 4
            \\Scan Size: 10 10 ~m
            \\@2:Image Data: S [LogStiffness] "LogDMTModulus"
            \\@2:Z scale: V [Sens. LogStiffnessSens] (0.00000000745058 log(Arb)/LSB) %s
            \\*File list end
            """;

    @TempDir
    Path folder;

    private ScanBytes open(UnaryOperator<String> change) throws IOException {
        String text = change.apply(TEXT);
        assertThat(text.length()).isLessThan(HEADER);
        ByteBuffer file = ByteBuffer.allocate(HEADER + Short.BYTES * COLUMNS * LINES)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put((text.replace("\n", "\r\n") + "\u001a").getBytes(StandardCharsets.ISO_8859_1))
                .position(HEADER);
        IntStream.range(0, COLUMNS * LINES).forEach(i -> file.putShort((short) i));
        return ScanBytes.open(Files.write(folder.resolve("scan.spm"), file.array()));
    }

    private ChannelList read(UnaryOperator<String> change) throws IOException {
        try (ScanBytes bytes = open(change)) {
            ChannelList channels = TestScans.channels(bytes);
            ScanChannel heights = channels.channels().get(channels.heights().orElseThrow());
            // 65.536 V over 65536 steps, 10 nm/V; the last line of the file is the top.
            assertThat(heights.samples().read()[0]).isCloseTo(0.01 * COLUMNS * (heights.rows() - 1), within(1e-12));
            assertThat(heights.unit()).isEqualTo("nm");
            return channels;
        }
    }

    private static void assertSides(ChannelList channels, double width, double height) {
        ScanChannel channel = channels.channels().get(0);
        assertThat(channel.extent().width().orElseThrow()).isCloseTo(width, within(1e-15));
        assertThat(channel.extent().height().orElseThrow()).isCloseTo(height, within(1e-15));
    }

    @ParameterizedTest
    @CsvSource({
        "1:1, 10 10 ~m, 10e-6",
        "2:1, 10 10 ~m, 5e-6",
        "1:2, 10 10 ~m, 20e-6",
        "2:1, 10 um, 5e-6",
        "4 : 1, 10000 10000 nm, 2.5e-6",
        "2, 10 10 ~m, 5e-6",
        "0.5, 10 10 ~m, 20e-6",
        // Both sides are given.
        "1:1, 10 5 ~m, 5e-6",
        "2:1, 10 5 ~m, 5e-6"
    })
    void theHeightFollowsFromTheAspectRatioUnlessBothSidesAreGiven(String aspect, String size, double height)
            throws IOException {
        UnaryOperator<String> change =
                text -> text.replace("Ratio: 1:1", "Ratio: " + aspect).replace("Size: 10 10 ~m", "Size: " + size);
        assertSides(read(change), 10e-6, height);
    }

    @ParameterizedTest
    @CsvSource({
        "'Number of lines: 4', 'Number of lines: 16'",
        "'Number of lines: 4', 'Number of lines: 16\n\\Valid data start Y: 0'"
    })
    void aScanThatWasStoppedHasTheLinesThatAreStored(String line, String longer) throws IOException {
        ChannelList channels = read(text -> text.replace(line, longer));

        assertThat(channels.channels().get(0).rows()).isEqualTo(LINES);
        assertSides(channels, 10e-6, 2.5e-6);
    }

    /** The file begins at the bottom; sample i has the height 0.01 i nm. */
    @ParameterizedTest
    @CsvSource({"0, 3", "1, 2", "3, 1"})
    void onlyValidLinesAreRead(int first, int lines) throws IOException {
        String valid = "len Y: " + lines + "\n\\Valid data start Y: " + first;
        try (ScanBytes bytes = open(text -> text.replace("len Y: 4", valid))) {
            ScanChannel heights = TestScans.channels(bytes).channels().get(0);
            double[] samples = heights.samples().read();

            assertThat(samples).hasSize(COLUMNS * lines);
            assertThat(samples[COLUMNS * (lines - 1)]).isCloseTo(0.01 * COLUMNS * first, within(1e-12));
            assertThat(heights.extent().height().orElseThrow()).isCloseTo(10e-6 * lines / LINES, within(1e-15));
        }
    }

    @ParameterizedTest
    @CsvSource({"32.00000 log(Arb)", "32.00000 log(Arb) of what", "see another list"})
    void theUnitOfAnotherChannelIsNoMatter(String value) throws IOException {
        ChannelList channels = read(text -> text.replace("\\*File list end\n", MODULUS.formatted(value)));

        assertThat(channels.count()).isEqualTo(2);
        assertThat(channels.channels().get(1).maybeHeights()).isFalse();
        assertThat(channels.heights()).contains(0);
    }

    @Test
    void filesOfElectrochemistryAreTheSame() throws IOException {
        assertThat(read(text -> text.replace("File list", "EC File list")).count())
                .isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({
        "'Number of lines: 4', 'Number of lines: 3', has 64 bytes for 8 x 3 samples",
        "'len Y: 4', 'len Y: 5', has valid data of 8 x 5 samples",
        "'len Y: 4', 'len Y: 3\n\\Valid data start Y: 2', from column 0 and line 2 on in 8 x 4",
        "'len Y: 4', 'len Y: 4\n\\Valid data len X: 7', has valid data of 7 x 4 samples",
        "'Number of lines: 4\n', '', 'has no \"number of lines\"'",
        "'\\Data offset: 2048\n', '', 'has no \"data offset\"'",
        "'Ratio: 1:1', 'Ratio: 1:0', 'aspect ratio of \"1:0\"'",
        "'Ratio: 1:1', 'Ratio: wide', 'aspect ratio of \"wide\"'",
        "'Z scale: V', 'Z scale: 5', 'no \"Z scale\" with volts'"
    })
    void aHeaderThatContradictsItselfIsRefused(String right, String wrong, String complaint) {
        assertThatThrownBy(() -> read(text -> text.replace(right, wrong)))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining(complaint);
    }
}
