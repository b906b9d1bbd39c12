package sunbeam.acceptance;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Measured patches and exact values, in a folder beside the repository that not every machine has. */
public final class SharedData {
    private static final Path FOLDER = Sunbeam.repository().resolveSibling("shared");

    private SharedData() {}

    /** The descriptor of a measured patch; without it the test is skipped. */
    public static Path patch(String name) {
        return present("patches/" + name + ".json");
    }

    /** The exact values {@code power} or {@code xyz} for a patch; without them the test is skipped. */
    public static CsvFile reference(String kind, String patch) throws IOException {
        return CsvFile.read(present("reference/" + kind + "_" + patch + ".csv"));
    }

    public static Path present(String name) {
        Path file = FOLDER.resolve(name);
        assumeTrue(Files.exists(file), () -> "skipped: needs " + name + " in a folder 'shared' beside the repository");
        return file;
    }
}
