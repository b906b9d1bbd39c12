package sunbeam.app.files.cache;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
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
import java.util.stream.Stream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.table.TableException;

/**
 * Where files lie that can be computed again: {@code $XDG_CACHE_HOME/sunbeam}, else {@code ~/.cache/sunbeam} (XDG Base
 * Directory Specification 0.8; a relative XDG_CACHE_HOME counts as none). Removing it costs time only.
 *
 * @param path of the folder, which need not exist
 * @param allowed bytes as the environment has them, empty for the standard
 */
public record CacheFolder(Path path, String allowed) {
    /** Bytes that a folder may take where the environment does not say how many. */
    public static final long STANDARD_LIMIT = 2_000_000_000;

    private static final String NAME = "sunbeam";
    private static final String LIMIT = "SUNBEAM_CACHE_LIMIT";
    private static final Set<PosixFilePermission> OWNERS_ONLY = PosixFilePermissions.fromString("rw-------");
    private static final Set<PosixFilePermission> OWNERS_FOLDER = PosixFilePermissions.fromString("rwx------");
    private static final FileAttribute<?>[] FOLDER_ATTRIBUTES = {PosixFilePermissions.asFileAttribute(OWNERS_FOLDER)};

    /** The folder of the environment's user. */
    public static CacheFolder of(Environment environment) {
        String variable = environment.variable("XDG_CACHE_HOME");
        boolean absolute = !variable.isEmpty() && Path.of(variable).isAbsolute();
        Path base = absolute ? Path.of(variable) : environment.home().resolve(".cache");
        return new CacheFolder(base.resolve(NAME), environment.variable(LIMIT));
    }

    /**
     * Makes the folder where it is missing.
     *
     * @param warning told in one line why there is no cache
     * @return the folder, which takes files, or nothing: then the work is done without a cache
     */
    public Optional<Path> open(Consumer<String> warning) {
        try {
            create(path);
            keepPrivate();
            // Sweeps away what killed processes left, too.
            AtomicFile.checkWritable(path.resolve("probe"), Overwrite.REPLACE);
            return Optional.of(path);
        } catch (IOException | OutputException failure) {
            warning.accept("no cache, so tables are computed anew each time: cannot write to " + path + " ("
                    + failure.getMessage() + "); set XDG_CACHE_HOME to a folder that takes files");
            return Optional.empty();
        }
    }

    /** Makes a folder and those above it, each of mode 700 as the XDG specification asks; what is there stays as it is. */
    private static void create(Path folder) throws IOException {
        Path above = folder.toAbsolutePath().getParent();
        if (Files.isDirectory(folder) || above == null) {
            return;
        }
        create(above);
        try {
            Files.createDirectory(folder, hasModes(above) ? FOLDER_ATTRIBUTES : new FileAttribute<?>[0]);
        } catch (FileAlreadyExistsException other) {
            // Another process has made it meanwhile, or a file has its name, which is noticed at the first write.
        }
    }

    /** Nobody else reads what was measured, or puts anything there. */
    private void keepPrivate() throws IOException {
        if (hasModes(path) && Files.isWritable(path)) {
            Files.setPosixFilePermissions(path, OWNERS_FOLDER);
        }
    }

    /** Attributes of a new file that its owner alone may read; none where a file system has no such. */
    static FileAttribute<?>[] ownersOnly(Path file) throws IOException {
        return hasModes(file.toAbsolutePath().getParent())
                ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNERS_ONLY)}
                : new FileAttribute<?>[0];
    }

    private static void makeOwnersOnly(Path file) throws IOException {
        if (hasModes(file)) {
            Files.setPosixFilePermissions(file, OWNERS_ONLY);
        }
    }

    private static boolean hasModes(Path file) throws IOException {
        return Files.getFileStore(file).supportsFileAttributeView("posix");
    }

    /**
     * The tables, those first that were used last; none when the folder does not exist. What another process deletes
     * meanwhile is left out.
     *
     * @throws UncheckedIOException when the folder cannot be listed
     */
    public List<CacheEntry> entries() {
        List<CacheEntry> entries = new ArrayList<>();
        for (Path file : files()) {
            try {
                BasicFileAttributes attributes =
                        Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
                if (attributes.isRegularFile()) {
                    Instant used = attributes.lastModifiedTime().toInstant();
                    entries.add(new CacheEntry(file, attributes.size(), used));
                }
            } catch (IOException gone) {
                // Another process has removed it meanwhile.
            }
        }
        entries.sort(Comparator.comparing(CacheEntry::lastUsed)
                .reversed()
                .thenComparing(entry -> entry.file().toString()));
        return entries;
    }

    private List<Path> files() {
        if (!Files.isDirectory(path)) {
            return List.of();
        }
        try (Stream<Path> listed = Files.list(path)) {
            return listed.filter(CacheEntry::isOne).toList();
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot list " + path, failure);
        }
    }

    /**
     * What a file has; nothing where it is missing, is no file of ours, or cannot be used.
     *
     * @param reader throws a {@link TableException} for what is damaged or something else
     * @param warning told of that in one line
     */
    <T> Optional<T> read(Path file, Function<Path, T> reader, Consumer<String> warning) {
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            return Optional.empty();
        }
        try {
            T kept = reader.apply(file);
            used(file);
            return Optional.of(kept);
        } catch (TableException failure) {
            // Cleared by another process a moment ago: as if it had never been there.
            if (Files.exists(file)) {
                warning.accept("cached table is made again: " + failure.getMessage());
            }
            return Optional.empty();
        }
    }

    /**
     * Keeps a file, and deletes others that there is no more room for.
     *
     * @param warning told in one line why it is not kept
     */
    void save(Path file, Consumer<Path> writer, Consumer<String> warning) {
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

    /** Notes that a table was read: what was used last goes last. */
    void used(Path file) {
        try {
            Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
        } catch (IOException deletedOrReadOnly) {
            return;
        }
    }

    /**
     * Bytes that the tables may take together: the variable {@code SUNBEAM_CACHE_LIMIT} ({@code 4GB}), else the standard.
     *
     * @throws UsageException where the variable is no size
     */
    public long limit() {
        try {
            return allowed.isEmpty() ? STANDARD_LIMIT : ByteSize.parse(allowed);
        } catch (IllegalArgumentException wrong) {
            throw new UsageException(LIMIT + ": " + wrong.getMessage());
        }
    }

    /** Bytes that one table may take: a quarter of the limit, so that one surface does not push out all others. */
    long largest() {
        return limit() / 4;
    }

    /**
     * Deletes tables, so that the rest is no larger than a limit: those that were used last stay, as far as they fit. Whoever
     * has one open goes on reading it. A table that cannot be deleted stays.
     *
     * @param inUse counts as used last
     * @return those that were deleted, the one used longest ago first
     */
    public List<CacheEntry> shrink(long limitBytes, Optional<Path> inUse) {
        List<CacheEntry> newestFirst = new ArrayList<>(entries());
        newestFirst.sort(Comparator.comparing(entry -> !inUse.equals(Optional.of(entry.file()))));
        long left = limitBytes;
        List<CacheEntry> deleted = new ArrayList<>();
        for (CacheEntry entry : newestFirst) {
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

    /**
     * Deletes all tables that can be deleted.
     *
     * @return those that were deleted
     */
    public List<CacheEntry> clear() {
        return entries().stream()
                .filter(entry -> entry.file().toFile().delete())
                .toList();
    }
}
