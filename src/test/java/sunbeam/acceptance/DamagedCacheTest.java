package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** A damaged table in the cache is detected, reported in one line and made again, and the map is right. */
class DamagedCacheTest extends InOneWorkplace {
    private static Path table;
    private static byte[] goodTable;
    private static byte[] goodMap;

    @BeforeAll
    static void makeATable() throws Exception {
        assertThat(map("first").complaints()).isEmpty();
        assertThat(workplace.tables()).hasSize(1);
        table = workplace.tables().get(0);
        goodTable = Files.readAllBytes(table);
        goodMap = Files.readAllBytes(workplace.resolve("first.npy"));
    }

    @Test
    void aTruncatedTable() throws Exception {
        assertMadeAgain(
                Arrays.copyOf(goodTable, goodTable.length / 2),
                "truncated: " + goodTable.length / 2 + " bytes left of " + goodTable.length);
    }

    @Test
    void aTableWithAFlippedBit() throws Exception {
        byte[] flipped = goodTable.clone();
        flipped[flipped.length / 2] ^= 0x10;
        assertMadeAgain(flipped, "its checksum does not fit: the file was altered or damaged");
    }

    @Test
    void aTableOfAnotherVersion() throws Exception {
        // The number after the signature of eight bytes.
        byte[] other = ByteBuffer.wrap(goodTable.clone()).putInt(8, 99).array();
        assertMadeAgain(other, "tables of version 99, this Sunbeam reads version ");
    }

    private static void assertMadeAgain(byte[] damaged, String reason) throws Exception {
        Files.write(table, damaged);

        SunbeamResult result = map("again");

        assertThat(result.complaints())
                .as("%s", result)
                .startsWith("sunbeam: warning: cached table is made again: cannot use " + table + ": " + reason)
                .hasLineCount(1);
        assertThat(workplace.resolve("again.npy")).hasBinaryContent(goodMap);
        assertThat(workplace.tables()).containsExactly(table);
        assertThat(table).as("the table made again").hasBinaryContent(goodTable);
    }

    private static SunbeamResult map(String name) throws IOException {
        return workplace.succeedHere(
                "brdf-map --patch blaze --size 9 --force --output %s.png --linear %s.npy", name, name);
    }
}
