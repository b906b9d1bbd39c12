package sunbeam.app.files.cache;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.plan.ShaderTablesFile;
import sunbeam.precompute.plan.TableLabel;

/**
 * Cache folder, whose files can be computed again: {@code $XDG_CACHE_HOME/sunbeam} (XDG Base Directory Specification 0.8, which ignores a
 * relative one), else in the folder of caches that the system has: {@code %LOCALAPPDATA%} on Windows, {@code ~/Library/Caches} on macOS,
 * {@code ~/.cache} elsewhere.
 *
 * @param allowed limit of the size as the environment states it; empty for {@link #STANDARD_LIMIT}
 */
public record CacheFolder(Path path, String allowed) {
    /** File of the cache with its length, and time of the last use or of the write. */
    public record Entry(Path file, long bytes, Instant lastUsed) {
        public static final String SHADER = "tables";
        public static final String TILES = "tiles";
        static final String BYTES = "bytes";

        /** Reads the label; throws InputException if the file is damaged, of another version, or gone. */
        public TableLabel label() {
            String name = file.getFileName().toString();
            return switch (name.substring(name.lastIndexOf('.') + 1)) {
                case TILES -> TileFile.label(file, TileFile.FORMAT);
                case BYTES -> TileFile.label(file, BlobCache.FORMAT);
                default -> ShaderTablesFile.label(file);
            };
        }
    }

    public static final long STANDARD_LIMIT = 2_000_000_000;

    // Hexadecimal digits in a file's name.
    private static final int SURFACE_DIGITS = 12;
    private static final int KEY_DIGITS = 32;

    private static final String LIMIT = "SUNBEAM_CACHE_LIMIT";
    private static final Set<PosixFilePermission> OWNERS_ONLY = PosixFilePermissions.fromString("rw-------");
    private static final Set<PosixFilePermission> OWNERS_FOLDER = PosixFilePermissions.fromString("rwx------");

    public static CacheFolder of(Environment environment) {
        return of(environment, System.getProperty("os.name"));
    }

    static CacheFolder of(Environment environment, String system) {
        Path home = environment.home();
        Path standard = home.resolve(system.startsWith("Mac") ? "Library/Caches" : ".cache");
        if (system.startsWith("Windows")) {
            standard = absolute(environment, "LOCALAPPDATA").orElseGet(() -> home.resolve("AppData/Local"));
        }
        Path base = absolute(environment, "XDG_CACHE_HOME").orElse(standard);
        return new CacheFolder(base.resolve("sunbeam"), environment.variable(LIMIT));
    }

    private static Optional<Path> absolute(Environment environment, String variable) {
        String value = environment.variable(variable);
        return value.isEmpty() ? Optional.empty() : Optional.of(Path.of(value)).filter(Path::isAbsolute);
    }

    /** Creates the folder if it is missing; empty, with one line of warning, if it takes no files. */
    public Optional<Path> open(Consumer<String> warning) {
        try {
            create();
            // Others could read measured heights or plant files.
            if (hasModes(path) && Files.isWritable(path)) {
                Files.setPosixFilePermissions(path, OWNERS_FOLDER);
            }
            // Also removes temporary files of killed processes.
            AtomicFile.checkWritable(path.resolve("probe"), Overwrite.REPLACE);
            return Optional.of(path);
        } catch (IOException | OutputException failure) {
            warning.accept("no cache, so tables are computed anew each time: cannot write to " + path + " ("
                    + failure.getMessage() + "); set XDG_CACHE_HOME to a folder that takes files");
            return Optional.empty();
        }
    }

    /** Returns the file of a surface's tables or tiles by their key; empty, with a warning, if the folder takes no files. */
    public Optional<Path> file(String surfaceDigest, String key, String ending, Consumer<String> warning) {
        return open(warning).map(path -> path.resolve(surface(surfaceDigest) + name(Sha256.of(key), ending)));
    }

    private static String surface(String digest) {
        return digest.substring(0, SURFACE_DIGITS) + "-";
    }

    static String name(String keyHash, String ending) {
        return keyHash.substring(0, KEY_DIGITS) + "." + ending;
    }

    /** True if there are tiles of a surface, in any light. */
    public boolean hasTiles(String surfaceDigest) {
        return entries().stream()
                .map(entry -> entry.file().getFileName().toString())
                .anyMatch(name -> name.startsWith(surface(surfaceDigest)) && name.endsWith("." + Entry.TILES));
    }

    /** Mode 700, as the XDG specification demands. */
    private void create() throws IOException {
        // createDirectories() alone refuses a link to a folder.
        if (!Files.isDirectory(path)) {
            boolean modes = path.getFileSystem().supportedFileAttributeViews().contains("posix");
            FileAttribute<?> mode = PosixFilePermissions.asFileAttribute(OWNERS_FOLDER);
            Files.createDirectories(path, modes ? new FileAttribute<?>[] {mode} : new FileAttribute<?>[0]);
        }
    }

    static void makeOwnersOnly(Path file) throws IOException {
        if (hasModes(file)) {
            Files.setPosixFilePermissions(file, OWNERS_ONLY);
        }
    }

    private static boolean hasModes(Path file) throws IOException {
        return Files.getFileStore(file).supportsFileAttributeView("posix");
    }

    /** Returns the files, last used first; throws {@link UncheckedIOException} if the folder cannot be listed. */
    public List<Entry> entries() {
        if (!Files.isDirectory(path)) {
            return List.of();
        }
        List<Entry> entries = new ArrayList<>();
        String names = "*.{" + String.join(",", Entry.SHADER, Entry.TILES, Entry.BYTES) + "}";
        try (DirectoryStream<Path> files = Files.newDirectoryStream(path, names)) {
            for (Path file : files) {
                try {
                    BasicFileAttributes attributes =
                            Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
                    if (attributes.isRegularFile()) {
                        Instant used = attributes.lastModifiedTime().toInstant();
                        entries.add(new Entry(file, attributes.size(), used));
                    }
                } catch (IOException gone) {
                    // Removed by another process.
                }
            }
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot list " + path, failure);
        } catch (DirectoryIteratorException failure) {
            throw new UncheckedIOException("cannot list " + path, failure.getCause());
        }
        entries.sort(Comparator.comparing(Entry::lastUsed)
                .reversed()
                .thenComparing(entry -> entry.file().toString()));
        return entries;
    }

    /** Reads a file; empty if it is missing or not regular, or, with a line of warning, if the reader throws {@link InputException}. */
    public <T> Optional<T> read(Path file, Function<Path, T> reader, Consumer<String> warning) {
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            return Optional.empty();
        }
        try {
            T content = reader.apply(file);
            used(file);
            return Optional.of(content);
        } catch (InputException failure) {
            if (Files.exists(file)) {
                warning.accept("cached table is made again: " + failure.getMessage());
            }
            return Optional.empty();
        }
    }

    /** True if something other than a file or a link has a file's place: the opening of a pipe would wait forever. */
    static boolean isObstructed(Path file) {
        return Files.exists(file, LinkOption.NOFOLLOW_LINKS)
                && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                && !Files.isSymbolicLink(file);
    }

    static String obstruction(Path file) {
        return file + " is no regular file; remove it";
    }

    /** Writes a file, or warns in one line; then deletes others until the folder is within its limit. */
    public void save(Path file, Consumer<Path> writer, Consumer<String> warning) {
        if (isObstructed(file)) {
            warning.accept("the table is not kept: " + obstruction(file));
            return;
        }
        try {
            AtomicFile.writeFile(file, Overwrite.REPLACE, path -> {
                makeOwnersOnly(path);
                writer.accept(path);
            });
            shrink(limit(), Optional.of(file));
        } catch (OutputException failure) {
            warning.accept("the table is not kept: " + failure.getMessage());
        }
    }

    void used(Path file) {
        try {
            Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
        } catch (IOException deletedOrReadOnly) {
            return;
        }
    }

    /** Returns bytes: {@code SUNBEAM_CACHE_LIMIT} (such as {@code 4GB}; else {@link UsageException}) or {@link #STANDARD_LIMIT}. */
    public long limit() {
        return allowed.isEmpty() ? STANDARD_LIMIT : UsageException.parsed(LIMIT + ": ", () -> ByteSize.parse(allowed));
    }

    /** A quarter of the folder's limit: one surface must not displace all others. */
    public long largest() {
        return limit() / 4;
    }

    /**
     * Deletes files until those used last, and the one in use, are within the limit; processes that have one open go on reading it. Returns
     * the deleted files, the one used longest ago first.
     */
    public List<Entry> shrink(long limitBytes, Optional<Path> inUse) {
        List<Entry> newestFirst = new ArrayList<>(entries());
        newestFirst.sort(Comparator.comparing(entry -> !inUse.equals(Optional.of(entry.file()))));
        long left = limitBytes;
        List<Entry> deleted = new ArrayList<>();
        for (Entry entry : newestFirst) {
            boolean fits = entry.bytes() <= left;
            if (!fits && entry.file().toFile().delete()) {
                deleted.add(entry);
            } else if (fits) {
                left -= entry.bytes();
            }
        }
        Collections.reverse(deleted);
        return deleted;
    }

    public List<Entry> clear() {
        return entries().stream()
                .filter(entry -> entry.file().toFile().delete())
                .toList();
    }
}
