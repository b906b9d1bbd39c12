package sunbeam.acceptance;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Surfaces with exact values from an independent program: synthetic ones among the tests' resources, measured ones in a
 * folder beside the repository that not every machine has. Tests of measured ones are skipped where it is missing.
 */
public final class SharedData {
    private static final Path SYNTHETIC = Sunbeam.repository().resolve("src/test/resources");
    private static final Path MEASURED = Sunbeam.repository().resolveSibling("shared");

    private SharedData() {}

    /** Returns the descriptor of a patch: {@code blaze} is synthetic, {@code elaphe} and {@code xenopeltis} are measured. */
    public static Path patch(String name) {
        return present("patches/" + name + ".json");
    }

    /** Returns the exact values {@code power} or {@code xyz} of a patch. */
    public static CsvFile reference(String kind, String patch) throws IOException {
        return CsvFile.read(present("reference/" + kind + "_" + patch + ".csv"));
    }

    /** Returns a file or folder of the hard cases; see their README. */
    public static Path hardCase(String name) {
        return SYNTHETIC.resolve("hard-cases").resolve(name);
    }

    /** Returns a synthetic or measured file; the test is skipped if it is missing. */
    public static Path present(String name) {
        Path synthetic = SYNTHETIC.resolve(name);
        if (Files.exists(synthetic)) {
            return synthetic;
        }
        Path measured = MEASURED.resolve(name);
        assumeTrue(
                Files.exists(measured), () -> "skipped: needs " + name + " in a folder 'shared' beside the repository");
        return measured;
    }
}
