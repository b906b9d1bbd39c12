package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A folder in which a user calls the program, and a cache folder of its own beside it. */
public record Workplace(Path folder, Path caches) {
    /** Two new folders, with blanks in their names, under an empty one. */
    public static Workplace in(Path root) throws IOException {
        return new Workplace(
                Files.createDirectories(root.resolve("a folder")), Files.createDirectories(root.resolve("the caches")));
    }

    /** A start of the program in the folder. */
    public Sunbeam command(String... arguments) {
        return equip(Sunbeam.command(arguments));
    }

    /** Moves any start here. What is left to start is short: compiling it for speed costs more than it saves. */
    public Sunbeam equip(Sunbeam start) {
        return start.in(folder)
                .with("XDG_CACHE_HOME", caches.toString())
                .with("SUNBEAM_JAVA_OPTIONS", "-XX:TieredStopAtLevel=1")
                .without("SUNBEAM_DEBUG");
    }

    /** A start of the program that must succeed. */
    public SunbeamResult succeed(String... arguments) throws IOException, InterruptedException {
        SunbeamResult result = command(arguments).run();
        assertThat(result.exitCode()).as("%s", result).isZero();
        return result;
    }

    /**
     * A command line run in this process, by the program's own front door: for what does not depend on how the program is
     * started, at a tenth of the cost of a start. Names of files mean those of the folder, in the result too.
     */
    public SunbeamResult here(String... arguments) throws IOException {
        return new InProcess(folder, caches).run(arguments);
    }

    /** A command line run in this process that must succeed. */
    public SunbeamResult succeedHere(String... arguments) throws IOException {
        SunbeamResult result = here(arguments);
        assertThat(result.exitCode()).as("%s", result).isZero();
        return result;
    }

    public Path resolve(String name) {
        return folder.resolve(name);
    }

    /** The folder's files, hidden ones too, sorted. */
    public List<String> files() throws IOException {
        return names(folder);
    }

    /** The tables in the cache, sorted. */
    public List<Path> tables() throws IOException {
        Path cache = caches.resolve("sunbeam");
        return names(cache).stream().map(cache::resolve).toList();
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
