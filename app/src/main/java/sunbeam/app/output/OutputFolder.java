package sunbeam.app.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Folders that commands write several files into. */
public final class OutputFolder {
    private OutputFolder() {}

    /**
     * Makes the folder where it is missing; its parent must be there.
     *
     * @throws OutputException when it cannot be made, or a file is in its place
     */
    public static void create(Path folder) {
        try {
            if (!Files.isDirectory(folder)) {
                Files.createDirectory(folder);
            }
        } catch (IOException failure) {
            throw new OutputException(
                    "cannot make the folder " + folder + " (" + failure.getMessage() + "); name another with --output",
                    failure);
        }
    }
}
