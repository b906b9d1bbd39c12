package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.HeightMap;

/** The cache's folder and the bytes that are kept in it. */
final class CacheFolderTest {
    @TempDir
    private Path home;

    private final List<String> warnings = new ArrayList<>();

    private CacheFolder cache(Map<String, String> variables) {
        return CacheFolder.of(new Environment(variables, home));
    }

    @Test
    void followsTheStandardVariableElseTheHomeFolder() {
        Path standard = home.resolve(".cache").resolve("sunbeam");
        assertThat(cache(Map.of()).path()).isEqualTo(standard);
        assertThat(cache(Map.of("XDG_CACHE_HOME", "")).path()).isEqualTo(standard);
        assertThat(cache(Map.of("XDG_CACHE_HOME", "relative")).path()).isEqualTo(standard);
        Path other = home.resolve("other");
        assertThat(cache(Map.of("XDG_CACHE_HOME", other.toString())).path()).isEqualTo(other.resolve("sunbeam"));
    }

    @Test
    void liesWhereTheSystemKeepsCaches() {
        Path local = home.resolve("local");
        Environment environment = new Environment(Map.of("LOCALAPPDATA", local.toString()), home);
        assertThat(CacheFolder.of(environment, "Windows 11").path()).isEqualTo(local.resolve("sunbeam"));
        assertThat(CacheFolder.of(new Environment(Map.of(), home), "Windows 11").path())
                .isEqualTo(home.resolve("AppData/Local/sunbeam"));
        assertThat(CacheFolder.of(environment, "Mac OS X").path()).isEqualTo(home.resolve("Library/Caches/sunbeam"));
        assertThat(CacheFolder.of(environment, "Linux").path()).isEqualTo(home.resolve(".cache/sunbeam"));
    }

    @Test
    void leastRecentlyUsedFilesAreDeletedFirst() throws IOException {
        CacheFolder cache = cache(Map.of());
        Path path = cache.open(warnings::add).orElseThrow();
        for (int i = 0; i < 4; i++) {
            Path file = Files.write(path.resolve(i + ".tables"), new byte[100]);
            Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000L + 1000L * i));
        }
        cache.used(path.resolve("0.tables"));

        assertThat(cache.shrink(250, Optional.of(path.resolve("3.tables"))))
                .extracting(entry -> entry.file().getFileName().toString())
                .containsExactly("1.tables", "2.tables");
        assertThat(path.toFile().list()).hasSize(2);
    }

    @Test
    void otherUsersCannotReadTheFolder() throws IOException {
        Path path = cache(Map.of()).open(warnings::add).orElseThrow();
        assertThat(Files.getPosixFilePermissions(path)).isEqualTo(PosixFilePermissions.fromString("rwx------"));
        assertThat(Files.getPosixFilePermissions(path.getParent()))
                .as(".cache, which was missing")
                .isEqualTo(PosixFilePermissions.fromString("rwx------"));
    }

    @Test
    void theEnvironmentSaysTheLimit() {
        assertThat(cache(Map.of()).limit()).isEqualTo(2_000_000_000);
        assertThat(cache(Map.of("SUNBEAM_CACHE_LIMIT", "12kB")).limit()).isEqualTo(12_000);
        assertThatThrownBy(() -> cache(Map.of("SUNBEAM_CACHE_LIMIT", "much")).limit())
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("much");
    }

    @Test
    void aFolderThatCannotBeMadeIsAWarningOnly() throws IOException {
        Path file = Files.createFile(home.resolve("file"));
        assertThat(cache(Map.of("XDG_CACHE_HOME", file.toString())).open(warnings::add))
                .isEmpty();
        assertThat(warnings).hasSize(1);
        assertThat(warnings.get(0)).contains("no cache", file.toString(), "XDG_CACHE_HOME");
    }

    private static final int MOST = 100;

    private int made;

    private byte[] get(String build, String name, int most) {
        return new BlobCache(Optional.ofNullable(build), cache(Map.of()), warnings::add).get(name, most, () -> {
            made++;
            return new byte[] {1, 2, 3};
        });
    }

    private byte[] get() {
        return get("build", "name", MOST);
    }

    private Path file() {
        return cache(Map.of()).entries().get(0).file();
    }

    @Test
    void bytesAreMadeOnceForEachBuildAndName() {
        assertThat(get()).containsExactly(1, 2, 3);
        assertThat(get()).containsExactly(1, 2, 3);
        assertThat(made).isEqualTo(1);
        get("another", "name", MOST);
        get("build", "another", MOST);
        assertThat(made).isEqualTo(3);
        assertThat(warnings).isEmpty();
    }

    @Test
    void nothingIsCachedForAProgramWithoutJars() {
        get(null, "name", MOST);
        get(null, "name", MOST);
        assertThat(made).isEqualTo(2);
        assertThat(BlobCache.jars(home.toString())).isEmpty();
    }

    @Test
    void anotherJarIsAnotherBuild() throws IOException {
        Path one = Files.write(home.resolve("one.jar"), new byte[1]);
        Path other = Files.write(home.resolve("two.jar"), new byte[1]);
        String path = one + File.pathSeparator + other;
        Optional<String> before = BlobCache.jars(path);
        assertThat(before).isPresent().isEqualTo(BlobCache.jars(path));
        Files.write(other, new byte[2]);
        assertThat(BlobCache.jars(path)).isNotEqualTo(before);
    }

    @Test
    void damagedTruncatedAndTooLongFilesAreMadeAgainWithAWarning() throws IOException {
        get();
        byte[] whole = Files.readAllBytes(file());
        for (int at = 0; at < whole.length; at++) {
            byte[] flipped = whole.clone();
            flipped[at] ^= 0x10;
            Files.write(file(), flipped);
            assertThat(get()).as("byte %d", at).containsExactly(1, 2, 3);
        }
        Files.write(file(), new byte[3]);
        get();
        Files.write(file(), new byte[100_000]);
        get();
        assertThat(made).isEqualTo(1 + whole.length + 2);
        assertThat(warnings)
                .hasSize(whole.length + 2)
                .allMatch(line -> line.startsWith("cached table is made again: "));
        assertThat(Files.readAllBytes(file())).isEqualTo(whole);
    }

    @Test
    void heightsComeBackToTheLastBit() {
        HeightMap map = new HeightMap(3, 2, 1e-7, 2e-7, new double[] {0, 1e-9, Math.PI, -0.0, 4, 5});
        for (int run = 0; run < 2; run++) {
            HeightMap kept = new BlobCache(Optional.of("build"), cache(Map.of()), warnings::add).heights("map", () -> {
                made++;
                return map;
            });
            // The digest of the heights, computed and cached.
            assertThat(new HeightMap(3, 2, kept.pitchX(), kept.pitchY(), kept.heights()).digest())
                    .isEqualTo(map.digest());
            assertThat(kept.digest()).isEqualTo(map.digest());
        }
        assertThat(made).isEqualTo(1);
        assertThat(cache(Map.of()).entries().get(0).label().what()).isEqualTo("heights of map");
    }

    @Test
    void numbersOfHeightsComeBackToTheLastBit() {
        BlobCache kept = new BlobCache(Optional.of("build"), cache(Map.of()), warnings::add);
        HeightMap map = new HeightMap(2, 1, 1, 1, new double[] {1, 2});
        HeightMap other = new HeightMap(2, 1, 1, 1, new double[] {1, 3});
        for (HeightMap each : List.of(map, map, other)) {
            double[] found = kept.numbers(each, "sum", () -> {
                made++;
                return new double[] {0.1 + each.heights()[1], -0.0};
            });
            assertThat(found).containsExactly(0.1 + each.heights()[1], -0.0);
        }
        assertThat(made).isEqualTo(2);
    }
}
