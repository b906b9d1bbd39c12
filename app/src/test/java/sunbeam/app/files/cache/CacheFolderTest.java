package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
    void openingCreatesTheFolder() {
        CacheFolder cache = cache(Map.of());
        assertThat(cache.entries()).isEmpty();
        assertThat(cache.open(warnings::add).orElseThrow()).isEmptyDirectory();
        assertThat(warnings).isEmpty();
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
}
