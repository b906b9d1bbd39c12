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
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.table.TableLabel;

final class PageFileTest {
    private static final TableLabel LABEL = new TableLabel("bläze", "table: 3 levels");
    private static final String KEY = "surface and plan";
    private static final long PLENTY = 1L << 30;
    private static final int PAGES = 6;
    private static final String DAMAGED = "cached colors are made again: some are damaged or cut off";

    @TempDir
    private Path folder;

    private final List<String> warnings = new ArrayList<>();

    private Path file() {
        return folder.resolve("one.pages");
    }

    private KeptPages open(String key, long mostBytes) {
        return PageFile.of(file(), key, NumberFormat.HALF, LABEL, mostBytes, warnings::add, () -> {});
    }

    private static byte[] coefficients(int level, int page) {
        byte[] values = new byte[LevelBaking.PAGE_NUMBERS * NumberFormat.HALF.bytes()];
        for (int i = 0; i < values.length; i++) {
            values[i] = (byte) (i * i / 7 + 10 * page + 100 * level);
        }
        return values;
    }

    private static BitSet all() {
        BitSet pages = new BitSet();
        pages.set(0, PAGES);
        return pages;
    }

    private void keepAll() {
        try (KeptPages pages = open(KEY, PLENTY)) {
            for (int page = 0; page < PAGES; page++) {
                pages.keep(page % 2, Map.of(page, coefficients(page % 2, page)));
            }
        }
    }

    /** Pages that a later run finds, each of which must be right. */
    private int found(String key) {
        int count = 0;
        try (KeptPages pages = open(key, PLENTY)) {
            for (int level = 0; level < 3; level++) {
                Map<Integer, byte[]> found = pages.read(level, all());
                count += found.size();
                for (Map.Entry<Integer, byte[]> page : found.entrySet()) {
                    assertThat(page.getKey() % 2).isEqualTo(level);
                    assertThat(page.getValue()).isEqualTo(coefficients(level, page.getKey()));
                }
            }
        }
        return count;
    }

    @Test
    void aLaterRunFindsThem() {
        keepAll();
        assertThat(found(KEY)).isEqualTo(PAGES);
        assertThat(PageFile.labelOf(file())).isEqualTo(LABEL);
        assertThat(warnings).isEmpty();
    }

    private static Map<Integer, byte[]> many(int count) {
        Map<Integer, byte[]> pages = new TreeMap<>();
        for (int page = 0; page < count; page++) {
            pages.put(page, coefficients(1, page));
        }
        return pages;
    }

    private void requireRight(Map<Integer, byte[]> found, int count) {
        assertThat(found).hasSize(count);
        found.forEach((page, values) -> assertThat(values).isEqualTo(coefficients(1, page)));
    }

    private static BitSet firstPages(int count) {
        BitSet pages = new BitSet();
        pages.set(0, count);
        return pages;
    }

    @Test
    void damageAmongManyCostsWhatItHits() throws IOException {
        try (KeptPages pages = open(KEY, PLENTY)) {
            pages.keep(1, many(600));
        }
        byte[] good = Files.readAllBytes(file());
        int record = recordBytes(good.length);
        byte[] bad = good.clone();
        bad[good.length - 100 * record + 50] ^= 1;
        Files.write(file(), bad);
        try (KeptPages pages = open(KEY, PLENTY)) {
            Map<Integer, byte[]> found = pages.read(1, firstPages(600));
            assertThat(found).doesNotContainKey(500);
            requireRight(found, 599);
        }
        Files.write(file(), Arrays.copyOf(good, good.length - 100 * record - 7));
        try (KeptPages pages = open(KEY, PLENTY)) {
            requireRight(pages.read(1, firstPages(600)), 499);
            pages.keep(1, many(600));
        }
        try (KeptPages pages = open(KEY, PLENTY)) {
            requireRight(pages.read(1, firstPages(600)), 600);
        }
        // The flipped bit, and the cut.
        assertThat(warnings).containsExactly(DAMAGED, DAMAGED);
    }

    @Test
    void nobodyElseReadsIt() throws IOException {
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
    void aFlippedBitAnywhereIsNoticedAndCostsOnePage() throws IOException {
        keepAll();
        byte[] good = Files.readAllBytes(file());
        for (int at = 0; at < good.length; at += 97) {
            byte[] bad = good.clone();
            bad[at] ^= 4;
            Files.write(file(), bad);
            int left = found(KEY);
            boolean inHead = at < good.length - PAGES * recordBytes(good.length);
            assertThat(left).as("byte %d of %d", at, good.length).isEqualTo(inHead ? 0 : PAGES - 1);
            Files.write(file(), good);
        }
        assertThat(warnings).isNotEmpty().allMatch(line -> line.equals(DAMAGED));
    }

    /** Coefficients, level, page and checksum. */
    private static int recordBytes(int fileBytes) {
        int record = LevelBaking.PAGE_NUMBERS * NumberFormat.HALF.bytes() + 16;
        assertThat(fileBytes).isGreaterThan(PAGES * record);
        return record;
    }

    @Test
    void whoComesSecondReadsAndDoesNotWrite() {
        keepAll();
        try (KeptPages first = open(KEY, PLENTY);
                KeptPages second = open(KEY, PLENTY)) {
            second.keep(2, Map.of(1, coefficients(2, 1)));
            first.keep(2, Map.of(2, coefficients(2, 2)));
            assertThat(second.read(0, all())).hasSize(PAGES / 2);
        }
        try (KeptPages later = open(KEY, PLENTY)) {
            assertThat(later.kept(2, all()).stream()).containsExactly(2);
        }
    }

    @Test
    void aFolderThatIsGoneKeepsNothing() {
        KeptPages pages = PageFile.of(
                folder.resolve("gone").resolve("one.pages"),
                KEY,
                NumberFormat.HALF,
                LABEL,
                PLENTY,
                warnings::add,
                () -> {});
        pages.keep(0, Map.of(1, coefficients(0, 1)));
        assertThat(pages.read(0, all())).isEmpty();
    }
}
