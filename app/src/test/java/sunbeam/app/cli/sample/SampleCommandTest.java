package sunbeam.app.cli.sample;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import sunbeam.app.cli.CommandLineFixture;

class SampleCommandTest extends CommandLineFixture {
    private static final int ROWS = 301;
    private static final int HEADER_BYTES = 128;

    private int sample(String output, String... more) {
        String[] arguments = Stream.concat(
                        Stream.of(
                                "sample",
                                "blaze",
                                "--coherence-length",
                                "4um",
                                "--tolerance",
                                "0.05",
                                "--output",
                                folder.resolve(output).toString()),
                        Arrays.stream(more))
                .toArray(String[]::new);
        return sunbeam(arguments);
    }

    private byte[] values(String file, String array) throws IOException {
        try (ZipFile zip = new ZipFile(folder.resolve(file).toFile())) {
            byte[] all = zip.getInputStream(zip.getEntry(array + ".npy")).readAllBytes();
            return Arrays.copyOfRange(all, HEADER_BYTES, all.length);
        }
    }

    @Test
    void thePartsAreTheWholeBitForBit() throws IOException {
        assertSuccess(sample("whole.npz", "--count", "" + ROWS));
        for (int part = 1; part <= 2; part++) {
            assertThat(sample(part + ".npz", "--count", "" + ROWS, "--task", part + "/2"))
                    .isZero();
        }
        for (String array : new String[] {"light", "view", "xyz", "density"}) {
            ByteArrayOutputStream parts = new ByteArrayOutputStream();
            parts.write(values("1.npz", array));
            parts.write(values("2.npz", array));
            assertThat(parts.toByteArray()).isEqualTo(values("whole.npz", array));
        }
    }

    @Test
    void whatCannotBeWrittenIsOneLineAndLeavesNothing() throws IOException {
        assertThat(sample("a.npz", "--count", "0")).isEqualTo(2);
        assertThat(sample("a.npz", "--count", "10", "--task", "3/2")).isEqualTo(2);
        assertThat(sample("a.npz", "--count", "1", "--task", "1/2")).isEqualTo(2);
        assertThat(sample("a.npz", "--count", "1000000000")).isEqualTo(2);
        assertThat(sample("a.csv", "--count", "1")).isEqualTo(2);
        assertThat(sample("a.npz", "--count", "1", "--channels", "spectral", "--illuminant", "A"))
                .isEqualTo(2);
        assertThat(err.toString().lines()).hasSize(6);
        try (Stream<Path> left = Files.list(folder)) {
            assertThat(left).isEmpty();
        }
    }
}
