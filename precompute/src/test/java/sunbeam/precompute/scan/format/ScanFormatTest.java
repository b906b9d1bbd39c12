package sunbeam.precompute.scan.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/** All formats give the same surface, and damaged files a complaint only. */
class ScanFormatTest {
    /** Seven digits of 500 nm, as 32-bit floats have. */
    private static final double ROUNDING = 5e-14;

    @TempDir
    Path folder;

    static Collection<String> formats() {
        return TestScans.FORMATS;
    }

    private Path file(byte[] content) throws IOException {
        // No extension: formats are found by content.
        return Files.write(folder.resolve("scan"), content);
    }

    @ParameterizedTest
    @MethodSource("formats")
    void readsTheHeightsTheirSizeAndWhichWayIsUp(String format) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(file(TestScans.file(format)))) {
            ChannelList channels = TestScans.channels(bytes);
            ScanChannel channel = channels.channels().get(channels.heights().orElseThrow());

            assertThat(channel.columns()).isEqualTo(TestScans.COLUMNS);
            assertThat(channel.rows()).isEqualTo(TestScans.ROWS);
            assertThat(channel.extent().width().orElseThrow()).isCloseTo(TestScans.WIDTH, within(1e-6 * 1e-6));
            assertThat(channel.extent().height().orElseThrow()).isCloseTo(TestScans.HEIGHT, within(1e-6 * 1e-6));
            double meters = channel.metersPerUnit().orElseThrow();
            assertThat(Arrays.stream(channel.samples().read())
                            .map(s -> s * meters)
                            .toArray())
                    .containsExactly(TestScans.meters(), within(ROUNDING));
        }
    }

    @ParameterizedTest
    @MethodSource("formats")
    void refusesATruncatedFile(String format) throws IOException {
        byte[] whole = TestScans.file(format);
        for (int length = 0; length < whole.length - 1; length += 1 + whole.length / 60) {
            int cut = length;
            assertReadOrRefused(Arrays.copyOf(whole, length), () -> format + " cut to " + cut);
        }
    }

    @ParameterizedTest
    @MethodSource("formats")
    void damagedFilesAreRefusedWithoutACrash(String format) throws IOException {
        byte[] whole = TestScans.file(format);
        Random random = new Random(12);
        for (int trial = 0; trial < 150; trial++) {
            byte[] damaged = whole.clone();
            int number = trial;
            for (int hit = 0; hit <= trial % 4; hit++) {
                // Every other trial damages the header.
                int reach = trial % 2 == 0 ? Math.min(600, whole.length) : whole.length;
                damaged[random.nextInt(reach)] = (byte) (trial % 3 == 0 ? 0xff : random.nextInt(256));
            }
            assertReadOrRefused(damaged, () -> format + ", trial " + number);
        }
    }

    /** Reads every channel; complaints are allowed. */
    private void assertReadOrRefused(byte[] content, Supplier<String> what) throws IOException {
        try (ScanBytes bytes = ScanBytes.open(file(content))) {
            ScanFormat reader = ScanFormat.find(bytes, Optional.empty()).orElse(null);
            if (reader == null) {
                return;
            }
            for (ScanChannel channel : reader.open(bytes).channels()) {
                channel.samples().read();
            }
        } catch (ScanException complaint) {
            assertThat(complaint.getMessage()).as(what).doesNotContain("\n").hasSizeBetween(10, 400);
        } catch (RuntimeException | OutOfMemoryError crash) {
            throw new AssertionError(what.get() + " crashes", crash);
        }
    }
}
