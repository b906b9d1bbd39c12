package sunbeam.app.cli.sample;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.cli.CommandLineFixture;

class SampleCommandTest extends CommandLineFixture {
    private static final int ROWS = 301;
    private static final int HEADER_BYTES = 128;

    private int sample(String output, String options) {
        return sunbeam("sample blaze --coherence-length 4um --tolerance 0.05 --output @" + output + " " + options);
    }

    private byte[] values(String file, String array) throws IOException {
        try (ZipFile zip = new ZipFile(folder.resolve(file).toFile())) {
            byte[] all = zip.getInputStream(zip.getEntry(array + ".npy")).readAllBytes();
            return Arrays.copyOfRange(all, HEADER_BYTES, all.length);
        }
    }

    @Test
    void thePartsAreTheWholeBitForBit() throws IOException {
        assertSuccess(sample("whole.npz", "--count " + ROWS));
        for (int part = 1; part <= 2; part++) {
            assertThat(sample(part + ".npz", "--count " + ROWS + " --task " + part + "/2"))
                    .isZero();
        }
        for (String array : new String[] {"light", "view", "xyz", "density"}) {
            ByteArrayOutputStream parts = new ByteArrayOutputStream();
            parts.write(values("1.npz", array));
            parts.write(values("2.npz", array));
            assertThat(parts.toByteArray()).isEqualTo(values("whole.npz", array));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "a.npz, --count 0, --count",
        "a.npz, --count 10 --task 3/2, --task",
        "a.npz, --count 1 --task 1/2, --task",
        "a.npz, --count 1000000000, --count",
        "a.csv, --count 1, a.csv",
        "a.npz, --count 1 --channels spectral --illuminant A, --illuminant"
    })
    void whatCannotBeWrittenIsOneLineAndLeavesNothing(String output, String options, String words) {
        assertThat(sample(output, options)).isEqualTo(2);
        assertThat(err.toString()).contains(words).hasLineCount(1);
        assertThat(folder).isEmptyDirectory();
    }
}
