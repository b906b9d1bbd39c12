package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A table in the cache that is not what was written: noticed, told in a line, made again, and the map is right. */
class DamagedCacheTest {
    @TempDir
    static Path root;

    private static Workplace workplace;
    private static Path table;
    private static byte[] goodTable;
    private static byte[] goodMap;

    @BeforeAll
    static void makeATable() throws Exception {
        workplace = Workplace.in(root);
        assertThat(map("first").complaints()).isEmpty();
        assertThat(workplace.tables()).hasSize(1);
        table = workplace.tables().get(0);
        goodTable = Files.readAllBytes(table);
        goodMap = Files.readAllBytes(workplace.resolve("first.npy"));
    }

    @Test
    void aGoodTableIsUsedAgain() throws Exception {
        Files.write(table, goodTable);
        Files.setLastModifiedTime(table, FileTime.fromMillis(0));
        Object written = fileKey();

        assertThat(map("second").complaints()).isEmpty();

        assertThat(fileKey()).as("a table made again would be another file").isEqualTo(written);
        assertThat(Files.getLastModifiedTime(table)).as("when it was used").isGreaterThan(FileTime.fromMillis(0));
        assertThat(workplace.resolve("second.npy")).hasBinaryContent(goodMap);
    }

    private static Object fileKey() throws IOException {
        return Files.readAttributes(table, BasicFileAttributes.class).fileKey();
    }

    @Test
    void aTruncatedTable() throws Exception {
        Files.write(table, Arrays.copyOf(goodTable, goodTable.length / 2));

        isMadeAgain("truncated: " + goodTable.length / 2 + " bytes left of " + goodTable.length);
    }

    @Test
    void anEmptyTable() throws Exception {
        Files.write(table, new byte[0]);

        isMadeAgain("truncated: 0 bytes are no tables");
    }

    @Test
    void aTableWithAFlippedBit() throws Exception {
        byte[] flipped = goodTable.clone();
        flipped[flipped.length / 2] ^= 0x10;
        Files.write(table, flipped);

        isMadeAgain("its checksum does not fit: the file was altered or damaged");
    }

    @Test
    void aTableOfAnotherVersion() throws Exception {
        byte[] other = goodTable.clone();
        // Behind the eight bytes that say whose file it is.
        ByteBuffer.wrap(other).putInt(8, 99);
        Files.write(table, other);

        isMadeAgain("tables of version 99, this Sunbeam reads version ");
    }

    @Test
    void aTableOfAnotherPlan() throws Exception {
        Workplace elsewhere = Workplace.in(Files.createDirectory(root.resolve("elsewhere")));
        elsewhere.succeedHere("brdf-map", "--patch", "sinusoid", "--size", "9", "--output", "other.png");
        Files.copy(elsewhere.tables().get(0), table, StandardCopyOption.REPLACE_EXISTING);

        isMadeAgain("tables of another surface or plan");
    }

    @Test
    void aFileOfAnotherProgram() throws Exception {
        Files.writeString(table, "weather in the mountains: fine, with some clouds in the evening");

        isMadeAgain("not tables of Sunbeam's");
    }

    private static void isMadeAgain(String reason) throws Exception {
        SunbeamResult result = map("again");

        assertThat(result.complaints())
                .as("%s", result)
                .startsWith("sunbeam: warning: cached table is made again: " + table + ": " + reason)
                .hasLineCount(1);
        assertThat(workplace.resolve("again.npy")).hasBinaryContent(goodMap);
        assertThat(workplace.tables()).containsExactly(table);
        assertThat(table).as("the table made again").hasBinaryContent(goodTable);
    }

    private static SunbeamResult map(String name) throws IOException {
        String commandLine =
                "brdf-map --patch blaze --size 9 --force --output " + name + ".png --linear " + name + ".npy";
        return workplace.succeedHere(commandLine.split(" ", -1));
    }
}
