package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.plan.TableLabel;

final class TileFileTest {
    private static final TableLabel LABEL = new TableLabel("bläze", "table: 3 levels");
    private static final String KEY = "surface and plan";
    private static final int TILES = 6;
    private static final String DAMAGED = "cached colors are made again: some are damaged or cut off";

    @TempDir
    private Path folder;

    private final List<String> warnings = new ArrayList<>();

    private Path file() {
        return folder.resolve("one.tiles");
    }

    private CachedTiles open(String key) {
        return TileFile.of(new CacheFolder(folder, ""), file(), key, NumberFormat.HALF, LABEL, warnings::add);
    }

    private static byte[] coefficients(int level, int tile) {
        byte[] values = new byte[LevelBaking.TILE_NUMBERS * NumberFormat.HALF.bytes()];
        for (int i = 0; i < values.length; i++) {
            values[i] = (byte) (i * i / 7 + 10 * tile + 100 * level);
        }
        return values;
    }

    private static BitSet all() {
        BitSet tiles = new BitSet();
        tiles.set(0, TILES);
        return tiles;
    }

    private void keepAll() {
        try (CachedTiles tiles = open(KEY)) {
            for (int tile = 0; tile < TILES; tile++) {
                tiles.keep(tile % 2, Map.of(tile, coefficients(tile % 2, tile)));
            }
        }
    }

    /** Number of tiles that a later run finds; asserts that each is right. */
    private int found(String key) {
        int count = 0;
        try (CachedTiles tiles = open(key)) {
            for (int level = 0; level < 3; level++) {
                Map<Integer, byte[]> found = tiles.read(level, all());
                count += found.size();
                for (Map.Entry<Integer, byte[]> tile : found.entrySet()) {
                    assertThat(tile.getKey() % 2).isEqualTo(level);
                    assertThat(tile.getValue()).isEqualTo(coefficients(level, tile.getKey()));
                }
            }
        }
        return count;
    }

    @Test
    void aLaterRunFindsCachedTiles() {
        keepAll();
        assertThat(found(KEY)).isEqualTo(TILES);
        assertThat(TileFile.label(file(), TileFile.FORMAT)).isEqualTo(LABEL);
        assertThat(warnings).isEmpty();
    }

    @Test
    void whatIsCutOffIsBakedAndAppendedAgain() throws IOException {
        keepAll();
        byte[] good = Files.readAllBytes(file());
        Files.write(file(), Arrays.copyOf(good, good.length - recordBytes(good.length) - 7));
        assertThat(found(KEY)).isEqualTo(TILES - 2);
        assertThat(warnings).containsExactly(DAMAGED);
        keepAll();
        assertThat(found(KEY)).isEqualTo(TILES);
    }

    @Test
    void otherUsersCannotReadTheFolder() throws IOException {
        keepAll();
        assertThat(Files.getPosixFilePermissions(file())).isEqualTo(PosixFilePermissions.fromString("rw-------"));
    }

    @Test
    void aLinkInItsPlaceIsNotFollowed() throws IOException {
        Path precious = folder.resolve("precious");
        Files.writeString(precious, "a letter");
        Files.createSymbolicLink(file(), precious);
        keepAll();
        assertThat(Files.readString(precious)).isEqualTo("a letter");
        assertThat(found(KEY)).isZero();
    }

    @Test
    void aFlippedBitAnywhereIsNoticedAndCostsOneTile() throws IOException {
        keepAll();
        byte[] good = Files.readAllBytes(file());
        for (int at = 0; at < good.length; at += 97) {
            byte[] bad = good.clone();
            bad[at] ^= 4;
            Files.write(file(), bad);
            int left = found(KEY);
            boolean inHead = at < good.length - TILES * recordBytes(good.length);
            assertThat(left).as("byte %d of %d", at, good.length).isEqualTo(inHead ? 0 : TILES - 1);
            Files.write(file(), good);
        }
        assertThat(warnings).isNotEmpty().allMatch(line -> line.equals(DAMAGED));
    }

    /** Coefficients, level, tile and checksum. */
    private static int recordBytes(int fileBytes) {
        int record = LevelBaking.TILE_NUMBERS * NumberFormat.HALF.bytes() + 16;
        assertThat(fileBytes).isGreaterThan(TILES * record);
        return record;
    }

    @Test
    void aSecondProcessReadsButDoesNotWrite() {
        keepAll();
        try (CachedTiles first = open(KEY);
                CachedTiles second = open(KEY)) {
            second.keep(2, Map.of(1, coefficients(2, 1)));
            first.keep(2, Map.of(2, coefficients(2, 2)));
            assertThat(second.read(0, all())).hasSize(TILES / 2);
        }
        try (CachedTiles later = open(KEY)) {
            assertThat(later.present(2, all()).stream()).containsExactly(2);
        }
    }

    @Test
    void aFolderThatIsGoneKeepsNothing() {
        Path gone = folder.resolve("gone");
        CachedTiles tiles = TileFile.of(
                new CacheFolder(gone, ""), gone.resolve("one.tiles"), KEY, NumberFormat.HALF, LABEL, warnings::add);
        tiles.keep(0, Map.of(1, coefficients(0, 1)));
        assertThat(tiles.read(0, all())).isEmpty();
    }

    /** To open a pipe, or to read from one, waits for another process. */
    @Test
    @Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void nothingIsReadFromAPipeOrAFolderInTheFilesPlace() throws IOException, InterruptedException {
        new ProcessBuilder("mkfifo", file().toString()).start().waitFor();
        keepAll();
        new CacheFolder(folder, "").save(file(), path -> {}, warnings::add);
        Files.delete(file());
        Files.createDirectory(file());
        keepAll();

        assertThat(warnings).hasSize(3).allMatch(line -> line.endsWith("one.tiles is no regular file; remove it"));
    }
}
