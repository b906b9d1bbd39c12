package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
        assertThat(map("first").stderr()).isEmpty();
        assertThat(workplace.tables()).hasSize(1);
        table = workplace.tables().get(0);
        goodTable = Files.readAllBytes(table);
        goodMap = Files.readAllBytes(workplace.resolve("first.npy"));
    }

    @Test
    void aGoodTableIsUsedAgain() throws Exception {
        Files.write(table, goodTable);
        var written = Files.getLastModifiedTime(table);

        assertThat(map("second").stderr()).isEmpty();

        assertThat(Files.getLastModifiedTime(table)).isEqualTo(written);
        assertThat(workplace.resolve("second.npy")).hasBinaryContent(goodMap);
    }

    @Test
    void aTruncatedTable() throws Exception {
        Files.write(table, Arrays.copyOf(goodTable, goodTable.length / 2));

        isMadeAgain("truncated: " + goodTable.length / 2 + " bytes left of " + goodTable.length);
    }

    @Test
    void anEmptyTable() throws Exception {
        Files.write(table, new byte[0]);

        isMadeAgain("not a readable HDF5 file");
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
        Files.deleteIfExists(table);
        try (WritableHdfFile file = HdfFile.write(table)) {
            file.putAttribute("format", "sunbeam fourier table");
            file.putAttribute("format_version", 99);
        }

        isMadeAgain("table of version 99, this Sunbeam reads version ");
    }

    @Test
    void aTableOfAnotherProgram() throws Exception {
        Files.deleteIfExists(table);
        try (WritableHdfFile file = HdfFile.write(table)) {
            file.putAttribute("format", "weather");
        }

        isMadeAgain("not a Sunbeam table");
    }

    private static void isMadeAgain(String reason) throws Exception {
        SunbeamResult result = map("again");

        assertThat(result.stderr())
                .as("%s", result)
                .startsWith("sunbeam: warning: cached table is made again: " + table + ": " + reason)
                .hasLineCount(1);
        assertThat(workplace.resolve("again.npy")).hasBinaryContent(goodMap);
        assertThat(workplace.tables()).containsExactly(table);
        assertThat(table).as("the table made again").hasBinaryContent(goodTable);
    }

    private static SunbeamResult map(String name) throws IOException, InterruptedException {
        String commandLine =
                "brdf-map --patch blaze --size 9 --force --output " + name + ".png --linear " + name + ".npy";
        return workplace.succeed(commandLine.split(" ", -1));
    }
}
