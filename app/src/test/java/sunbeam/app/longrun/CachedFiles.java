package sunbeam.app.longrun;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Files of one kind in the cache. */
final class CachedFiles {
    private CachedFiles() {}

    /**
     * None where there is no cache yet.
     *
     * @param cache the folder that holds the cache's folder
     * @param ending of the names, with its dot
     */
    static List<Path> find(Path cache, String ending) {
        Path folder = cache.resolve("sunbeam");
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(ending)).toList();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
