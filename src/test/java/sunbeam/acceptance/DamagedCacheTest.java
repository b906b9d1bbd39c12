package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

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

    private static Stream<Arguments> damages() {
        int half = goodTable.length / 2;
        byte[] flipped = goodTable.clone();
        flipped[half] ^= 0x10;
        // The number after the signature of eight bytes.
        byte[] other = ByteBuffer.wrap(goodTable.clone()).putInt(8, 99).array();
        return Stream.of(
                Arguments.of(
                        Arrays.copyOf(goodTable, half), "truncated: " + half + " bytes left of " + goodTable.length),
                Arguments.of(flipped, "its checksum does not fit: the file was altered or damaged"),
                Arguments.of(other, "tables of version 99, this Sunbeam reads version "));
    }

    @ParameterizedTest
    @MethodSource("damages")
    void aDamagedTableIsMadeAgain(byte[] damaged, String reason) throws Exception {
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
