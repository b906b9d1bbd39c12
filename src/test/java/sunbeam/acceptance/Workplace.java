package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Folder in which a user runs the program, with its own cache folder. */
public record Workplace(Path folder, Path caches) {
    /** Creates both folders, with blanks in their names, in an empty one. */
    public static Workplace in(Path root) throws IOException {
        return new Workplace(
                Files.createDirectories(root.resolve("a folder")), Files.createDirectories(root.resolve("the caches")));
    }

    /** Returns a start of the program in the folder. */
    public Sunbeam command(String... arguments) {
        return equip(Sunbeam.command(arguments));
    }

    /** Moves a start here. Runs are short, so optimizing compilation would cost more than it saves. */
    public Sunbeam equip(Sunbeam start) {
        return start.in(folder)
                .with("XDG_CACHE_HOME", caches.toString())
                .with("SUNBEAM_JAVA_OPTIONS", "-XX:TieredStopAtLevel=1")
                .without("SUNBEAM_DEBUG");
    }

    /** Starts the program, which must succeed. */
    public SunbeamResult succeed(String... arguments) throws IOException, InterruptedException {
        SunbeamResult result = command(arguments).run();
        assertThat(result.exitCode()).as("%s", result).isZero();
        return result;
    }

    /** Runs a command line in this process, at a tenth of the cost of a start. File names refer to the folder, also in the result. */
    public SunbeamResult here(String... arguments) throws IOException {
        return new InProcess(folder, caches).run(arguments);
    }

    /** Runs a command line in this process, which must succeed. */
    public SunbeamResult succeedHere(String... arguments) throws IOException {
        SunbeamResult result = here(arguments);
        assertThat(result.exitCode()).as("%s", result).isZero();
        return result;
    }

    public Path resolve(String name) {
        return folder.resolve(name);
    }

    /** Returns the folder's files including hidden ones, sorted. */
    public List<String> files() throws IOException {
        return names(folder);
    }

    /** Returns the files in the cache, sorted. */
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
