package sunbeam.precompute.files;

import java.nio.charset.StandardCharsets;
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

    /** Returns the beginning of a name that has at most these bytes in UTF-8. */
    public static String cut(String name, int mostBytes) {
        int end = name.length();
        while (name.substring(0, end).getBytes(StandardCharsets.UTF_8).length > mostBytes) {
            end = name.offsetByCodePoints(end, -1);
        }
        return name.substring(0, end);
    }
}
