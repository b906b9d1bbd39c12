package sunbeam.app.files.cache;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;

/**
 * Where files lie that can be computed again: {@code $XDG_CACHE_HOME/sunbeam}, else {@code ~/.cache/sunbeam} (XDG Base
 * Directory Specification 0.8; a relative XDG_CACHE_HOME counts as none). Removing it costs time only.
 */
public final class CacheFolder {
    private static final String NAME = "sunbeam";

    private final Path path;

    private CacheFolder(Path path) {
        this.path = path;
    }

    /** The folder of the environment's user, which need not exist. */
    public static CacheFolder of(Environment environment) {
        String variable = environment.variable("XDG_CACHE_HOME");
        boolean absolute = !variable.isEmpty() && Path.of(variable).isAbsolute();
        Path base = absolute ? Path.of(variable) : environment.home().resolve(".cache");
        return new CacheFolder(base.resolve(NAME));
    }

    public Path path() {
        return path;
    }

    /**
     * Makes the folder where it is missing.
     *
     * @param warning told in one line why there is no cache
     * @return the folder, which takes files, or nothing: then the work is done without a cache
     */
    public Optional<Path> open(Consumer<String> warning) {
        try {
            Files.createDirectories(path);
            // Sweeps away what killed processes left, too.
            AtomicFile.checkWritable(path.resolve("probe"), Overwrite.REPLACE);
            return Optional.of(path);
        } catch (IOException | OutputException failure) {
            warning.accept("no cache, so tables are computed anew each time: cannot write to " + path + " ("
                    + failure.getMessage() + "); set XDG_CACHE_HOME to a folder that takes files");
            return Optional.empty();
        }
    }

    /**
     * Deletes files, those first that were written longest ago, until the rest is no larger than a limit. A file that
     * cannot be deleted stays.
     *
     * @param newest stays in any case
     */
    public void shrink(long limitBytes, Path newest) {
        try (Stream<Path> listed = Files.list(path)) {
            List<File> files = listed.map(Path::toFile)
                    .filter(File::isFile)
                    .sorted(Comparator.comparingLong(File::lastModified))
                    .toList();
            long bytes = files.stream().mapToLong(File::length).sum();
            for (File file : files) {
                if (bytes > limitBytes && !file.toPath().equals(newest)) {
                    long length = file.length();
                    bytes -= file.delete() ? length : 0;
                }
            }
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot list " + path, failure);
        }
    }

    /**
     * Bytes in the folder's files; 0 when it does not exist.
     *
     * @throws UncheckedIOException when it cannot be listed
     */
    public long sizeInBytes() {
        if (!Files.isDirectory(path)) {
            return 0;
        }
        try (Stream<Path> files = Files.walk(path)) {
            return files.map(Path::toFile)
                    .filter(file -> file.isFile())
                    .mapToLong(file -> file.length())
                    .sum();
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot list " + path, failure);
        }
    }
}
