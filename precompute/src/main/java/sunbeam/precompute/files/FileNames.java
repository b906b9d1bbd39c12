package sunbeam.precompute.files;

import java.nio.file.Path;

/** Names of files. */
public final class FileNames {
    private FileNames() {}

    /** Returns the name without folder and last extension. */
    public static String stem(Path file) {
        String name = String.valueOf(file.getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
