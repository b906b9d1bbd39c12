package sunbeam.app.viewer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;

/**
 * Files that the user loaded last, one a line in {@code $XDG_STATE_HOME/sunbeam/recent-files}, else {@code
 * ~/.local/state/sunbeam/recent-files} (XDG Base Directory Specification 0.8).
 */
public record RecentFiles(Path list) {
    private static final int MOST = 8;
    private static final long LONGEST_LIST_BYTES = 1 << 16;

    public static RecentFiles of(Environment environment) {
        String state = environment.variable("XDG_STATE_HOME");
        Path base = state.startsWith("/") ? Path.of(state) : environment.home().resolve(".local/state");
        return new RecentFiles(base.resolve("sunbeam/recent-files"));
    }

    /** Returns the files that are still there, the last one first; none if the list cannot be read. */
    public List<Path> files() {
        try {
            return !Files.isRegularFile(list) || Files.size(list) > LONGEST_LIST_BYTES
                    ? List.of()
                    : Files.readAllLines(list).stream()
                            .map(Path::of)
                            .filter(file -> file.isAbsolute() && Files.isRegularFile(file))
                            .limit(MOST)
                            .toList();
        } catch (IOException | InvalidPathException damaged) {
            return List.of();
        }
    }

    void add(Path file) {
        List<Path> files = new ArrayList<>(files());
        files.remove(file.toAbsolutePath());
        files.add(0, file.toAbsolutePath());
        OutputFolder.createWithParents(list.getParent());
        String lines =
                String.join("\n", files.stream().limit(MOST).map(Path::toString).toList());
        AtomicFile.write(list, Overwrite.REPLACE, AtomicFile.StreamContent.of(lines));
    }
}
