package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.scan.format.GwyddionConversion;

/** Formats that only Gwyddion knows. */
class ThroughGwyddionTest {
    private static final int COLUMNS = 6;
    private static final int ROWS = 4;

    @TempDir
    Path folder;

    /** BCR-STM: a text header of 2048 bytes and 16-bit integers from the top row. */
    private Path bcr() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(2048 + 2 * COLUMNS * ROWS).order(ByteOrder.LITTLE_ENDIAN);
        String header = """
                fileformat = bcrstm
                headersize = 2048
                xpixels = 6
                ypixels = 4
                xlength = 3000
                ylength = 2000
                xunit = nm
                yunit = nm
                zunit = nm
                bit2nm = 1
                intelmode = 1
                """;
        bytes.put(header.getBytes(StandardCharsets.US_ASCII)).position(2048);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            bytes.putShort((short) (i * i));
        }
        return Files.write(folder.resolve("scan.bcr"), bytes.array());
    }

    @Test
    void aFormatThatOnlyGwyddionKnowsIsReadThroughIt() throws IOException {
        Path file = bcr();
        assumeTrue(
                new GwyddionConversion(System.getenv()).isInstalled(), "Gwyddion is not installed, or has no display");

        Patch patch = new PatchLoader(List.of(), BuiltInPatches::generate)
                .load(PatchRequests.parse(file.toString(), null, null, null, null, "none"));

        assertThat(patch.source()).contains("scan.bcr (through Gwyddion", "6 x 4 samples, 3 um x 2 um");
        assertThat(patch.scan().at(1, 0)).isCloseTo(1e-9, within(1e-18));
        assertThat(patch.scan().at(5, 3)).isCloseTo(23 * 23e-9, within(1e-18));
    }

    @Test
    void withoutGwyddionThereIsNoConversion() {
        assertThat(new GwyddionConversion(Map.of("PATH", folder.toString(), "DISPLAY", ":1")).isInstalled())
                .isFalse();
    }

    /** Nothing is wrong with the file: its reader must not be told to check it. */
    @Test
    void withoutRoomForItsResultTheFolderIsNamed() throws IOException {
        Path file = bcr();
        assumeTrue(
                new GwyddionConversion(System.getenv()).isInstalled(), "Gwyddion is not installed, or has no display");
        String before =
                System.setProperty("java.io.tmpdir", folder.resolve("missing").toString());
        try {
            assertThatThrownBy(() -> new PatchLoader(List.of(), BuiltInPatches::generate)
                            .load(PatchRequests.parse(file.toString(), null, null, null, null, "none")))
                    .isInstanceOf(PatchException.class)
                    .hasMessageContaining("scan.bcr is in a format that Sunbeam reads through Gwyddion")
                    .hasMessageContaining("folder for temporary files, " + folder.resolve("missing"))
                    .hasMessageContaining("free some space there");
        } finally {
            System.setProperty("java.io.tmpdir", before);
        }
    }

    @Test
    void whatGwyddionCannotReadEitherIsRefusedInItsWords() throws IOException {
        Path program = Files.writeString(
                folder.resolve("gwyddion"), "#!/bin/sh\necho \"$2: No module can load this file type.\"\n");
        assumeTrue(program.toFile().setExecutable(true), "programs cannot be made here");
        GwyddionConversion conversion = new GwyddionConversion(Map.of("PATH", folder.toString(), "DISPLAY", ":1"));

        assertThatThrownBy(() -> conversion.convert(bcr(), folder))
                .hasMessageContaining("No module can load this file type")
                .hasMessageContaining("export it as .gwy, .gsf or text");
    }
}
