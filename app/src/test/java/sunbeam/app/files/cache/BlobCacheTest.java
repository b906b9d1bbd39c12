package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.optics.HeightMap;

class BlobCacheTest {
    private static final int MOST = 100;

    @TempDir
    private Path home;

    private final List<String> warnings = new ArrayList<>();
    private int made;

    private byte[] get(String build, String name, int most) {
        return new BlobCache(Optional.ofNullable(build), folder(), warnings::add).get(name, most, () -> {
            made++;
            return new byte[] {1, 2, 3};
        });
    }

    private byte[] get() {
        return get("build", "name", MOST);
    }

    private CacheFolder folder() {
        return CacheFolder.of(new Environment(Map.of(), home));
    }

    private Path file() {
        return folder().entries().get(0).file();
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
            HeightMap kept = new BlobCache(Optional.of("build"), folder(), warnings::add).heights("map", () -> {
                made++;
                return map;
            });
            // The digest of the heights, computed and cached.
            assertThat(new HeightMap(3, 2, kept.pitchX(), kept.pitchY(), kept.heights()).digest())
                    .isEqualTo(map.digest());
            assertThat(kept.digest()).isEqualTo(map.digest());
        }
        assertThat(made).isEqualTo(1);
        assertThat(folder().entries().get(0).label().what()).isEqualTo("heights of map");
    }

    @Test
    void numbersOfHeightsComeBackToTheLastBit() {
        BlobCache kept = new BlobCache(Optional.of("build"), folder(), warnings::add);
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
