package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A folder in which a user calls the program, and a cache folder of its own beside it. */
record Workplace(Path folder, Path caches) {
    /** Two new folders, with blanks in their names, under an empty one. */
    static Workplace in(Path root) throws IOException {
        return new Workplace(
                Files.createDirectories(root.resolve("a folder")), Files.createDirectories(root.resolve("the caches")));
    }

    /** A start of the program in the folder. */
    Sunbeam command(String... arguments) {
        return equip(Sunbeam.command(arguments));
    }

    /** Moves any start here. */
    Sunbeam equip(Sunbeam start) {
        return start.in(folder)
                .with("XDG_CACHE_HOME", caches.toString())
                .without("SUNBEAM_JAVA_OPTIONS")
                .without("SUNBEAM_DEBUG");
    }

    /** A start of the program that must succeed. */
    SunbeamResult succeed(String... arguments) throws IOException, InterruptedException {
        SunbeamResult result = command(arguments).run();
        assertThat(result.exitCode()).as("%s", result).isZero();
        return result;
    }

    Path resolve(String name) {
        return folder.resolve(name);
    }

    /** The folder's files, hidden ones too, sorted. */
    List<String> files() throws IOException {
        return names(folder);
    }

    /** The tables in the cache, sorted. */
    List<Path> tables() throws IOException {
        Path cache = caches.resolve("sunbeam");
        return names(cache).stream()
                .filter(name -> !name.endsWith(".lock"))
                .map(cache::resolve)
                .toList();
    }

    private static List<String> names(Path directory) throws IOException {
        if (!Files.isDirectory(directory)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
