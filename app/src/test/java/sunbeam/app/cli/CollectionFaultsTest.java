package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.terminal.ExitCode;

/** Files, names and outputs that cannot be used are rows, or one line. */
final class CollectionFaultsTest extends CollectionFixture {
    /** A scan whose descriptor cannot be used is a surface of its own. */
    @Test
    void badFilesAreRowsAndDoNotStopTheRest() throws IOException {
        Files.writeString(scans.resolve("a bad one.gwy"), "no scan");
        Files.writeString(scans.resolve("b.json"), "{\"heights\": \"b.json\", \"width\": \"10 um\"}");
        Files.writeString(scans.resolve("c.json"), "{\"heights\": \"grating.txt\", \"width\": -5}");
        Files.writeString(scans.resolve("d.json"), "{\"heights\": \"grating.txt\", \"no key\": 1}");
        // Half of a pair of surrogates.
        Files.writeString(scans.resolve("e.json"), "{\"heights\": \"grating.txt\", \"width\": \"20 \\ud800um\"}");

        assertThat(inspect("@scans")).isEqualTo(4);

        assertThat(column("exit_code")).containsExactly("4", "4", "4", "4", "4", "0");
        assertThat(column("message").get(0)).contains("a bad one.gwy is neither an image nor a scan");
        assertThat(column("verdict_code").get(5)).isEqualTo("sure_grating");
        assertThat(err.toString()).hasLineCount(5).contains("a bad one.gwy");
    }

    @Test
    void aMissingFileOfSeveralAndAPipeAreRows() throws Exception {
        assertThat(new ProcessBuilder("mkfifo", scans.resolve("a pipe.txt").toString())
                        .start()
                        .waitFor())
                .isZero();

        assertThat(inspect("@scans @missing.gsf")).isEqualTo(4);

        assertThat(column("exit_code")).containsExactly("4", "0", "4");
        assertThat(column("message").get(0)).contains("a pipe.txt", "it is no regular file");
        assertThat(column("message").get(2)).contains("missing.gsf", "existing file");
    }

    /** Terabytes outside of the folder would take hours to read; the kernel's files may never end. */
    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void filesOutsideOfTheFolderAreNotRead() throws IOException {
        Path outside = folder.resolve("outside.gsf");
        try (RandomAccessFile sparse = new RandomAccessFile(outside.toFile(), "rw")) {
            sparse.setLength(1L << 40);
        }
        Files.createSymbolicLink(scans.resolve("a link.gsf"), outside);
        Files.writeString(scans.resolve("b.json"), "{\"heights\": \"../outside.gsf\"}");
        Files.writeString(scans.resolve("c.json"), "{\"heights\": \"/proc/self/pagemap\", \"width\": \"10um\"}");
        Files.createSymbolicLink(scans.resolve("d.json"), Path.of("/proc/self/pagemap"));
        Files.createSymbolicLink(scans.resolve("e.gsf"), Path.of("e.gsf"));
        Files.createDirectory(scans.resolve("folder.png"));

        assertThat(inspect("@scans")).isEqualTo(4);

        assertThat(column("exit_code")).containsExactly("4", "4", "4", "4", "4", "0");
        assertThat(column("message").get(1)).contains("b.json", "leads out of the descriptor's own folder");
        assertThat(column("message").get(2)).contains("c.json", "leads out of the descriptor's own folder");
        assertThat(column("message").get(3)).contains("d.json", "a link that leads out");
        assertThat(column("message").get(4)).contains("e.gsf", "existing file");
        assertThat(column("verdict_code").get(5)).isEqualTo("sure_grating");
        assertThat(inspect("@scans --resume")).isEqualTo(4);
        assertThat(column("exit_code")).containsExactly("4", "4", "4", "4", "4", "0");
        // JUnit warns of links that lead out of its folder.
        Files.delete(scans.resolve("d.json"));
    }

    @Test
    void aLinkToAScanOutsideOfTheFolderIsARow() throws IOException {
        Path inside = scans.resolve("grating.txt");
        Path link = Files.createSymbolicLink(scans.resolve("a.txt"), Files.copy(inside, folder.resolve("outside.txt")));
        Files.writeString(scans.resolve("b.json"), "{\"heights\": \"a.txt\"}");
        Files.createSymbolicLink(scans.resolve("c.txt"), inside);

        assertThat(inspect("@scans")).isEqualTo(4);

        assertThat(column("exit_code")).containsExactly("4", "4", "0", "0");
        assertThat(column("message").get(0)).contains("a.txt is a link that leads out of the folder");
        assertThat(inspect("@scans/a.txt @scans/c.txt --force")).isZero();
        Files.delete(link);
    }

    @Test
    void theLongestNamesHaveRowsAndPictures() throws IOException {
        for (String last : List.of("a", "b")) {
            Files.copy(scans.resolve("grating.txt"), scans.resolve("x".repeat(254) + last));
        }

        assertSuccess(inspect("@scans"));

        assertThat(column("verdict_code")).containsOnly("sure_grating").hasSize(3);
        assertThat(report.resolve("surfaces").toFile().list())
                .containsExactlyInAnyOrder("grating.png", "x".repeat(200) + ".png", "x".repeat(200) + "-2.png");
    }

    @Test
    void anOutputThatCannotBeWrittenIsARow() throws IOException {
        Files.copy(scans.resolve("grating.txt"), scans.resolve("b.txt"));
        Files.createDirectories(report.resolve("surfaces/b.png"));

        assertThat(inspect("@scans --force")).isEqualTo(6);

        assertThat(column("exit_code")).containsExactly("6", "0");
        assertComplaint(ExitCode.OUTPUT_EXISTS, "inspect @scans --output @report", "table.csv: it exists");
        Files.delete(report.resolve("table.csv"));
        Files.delete(report.resolve("reports.jsonl"));
        assertComplaint(
                ExitCode.OUTPUT_EXISTS, "inspect @scans --output @report", "surfaces/b.png: it exists", "--resume");
        Files.delete(report.resolve("surfaces/b.png"));
        assertSuccess(inspect("@scans --resume"));
    }

    @Test
    void namesAreNoFormulasAndControlNothing() throws IOException {
        String name = "=HYPERLINK(1)\u001b[31m\u202e\rred";
        Files.move(scans.resolve("grating.txt"), scans.resolve(name));
        Path here = Files.createDirectory(folder.resolve("@report"));

        assertThat(sunbeam("color " + scans + " --angles -40:40:4 --output " + here))
                .isZero();

        String colors = Files.readString(here.resolve("surfaces").resolve(name + ".csv"));
        assertThat(colors)
                .contains("\n'=HYPERLINK(1)\\u001b[31m\\u202e\\u000dred,")
                .doesNotContain("\u001b", "\r");
        String table = Files.readString(here.resolve("table.csv"));
        assertThat(table).contains("=HYPERLINK(1)\\u001b[31m\\u202e\\u000dred").doesNotContain("\u001b", "\r");
        assertThat(out.toString() + err).doesNotContain("\u001b", "\u202e", "\r");
    }

    @Test
    void namesWithBlanksAndLineBreaksAndEqualNamesHaveRowsAndPicturesOfTheirOwn() throws IOException {
        Path other = Files.createDirectory(folder.resolve("b"));
        Files.copy(scans.resolve("grating.txt"), other.resolve("grating.txt"));
        Files.copy(scans.resolve("grating.txt"), other.resolve("two\nlines \"and\" blanks .txt "));

        assertSuccess(inspect("@scans " + other));

        assertThat(column("file"))
                .containsExactly(
                        scans.resolve("grating.txt").toString(),
                        other.resolve("grating.txt").toString(),
                        other.resolve("two\nlines \"and\" blanks .txt ").toString());
        assertThat(report.resolve("surfaces").toFile().list())
                .containsExactlyInAnyOrder("grating.png", "grating-2.png", "two\nlines \"and\" blanks .png");
        // The sheet tells the equal files apart by their folders' names.
        BufferedImage sheet = ImageIO.read(report.resolve("sheet.png").toFile());
        assertThat(sheet.getRGB(16, 40, 284, sheet.getHeight() - 40, null, 0, 284))
                .isNotEqualTo(sheet.getRGB(316, 40, 284, sheet.getHeight() - 40, null, 0, 284));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            inspect @empty --output @report               | UNUSABLE_INPUT | the folder & empty has no scan
            inspect blaze --resume --output @report       | USAGE          | --resume is for several
            inspect blaze --theta-i 0:80 --output @report | USAGE          | --theta-i & min:max:step
            color @scans --with blaze --output @report    | USAGE          | --with is for one patch
            color @scans --output a.png                   | USAGE          | --output & folder
            inspect blaze no-such-file --output @report   | UNUSABLE_INPUT | no-such-file' is neither & needs quotes
            evaluate blaze --resume --output @report      | USAGE          | --resume is for several
            precompute --patch @scans --output @r.h5      | UNUSABLE_INPUT | scans & folder
            """)
    void mistakesAreOneLine(String command, ExitCode code, String words) throws IOException {
        Files.createDirectory(folder.resolve("empty"));
        assertComplaint(code, command, words.split(" & "));
    }

    @Test
    void whatOthersOrOtherPartsWroteStays() throws IOException {
        assertSuccess(inspect("@scans --task 2/2"));
        Files.writeString(report.resolve("table.csv"), "mine");
        assertComplaint(ExitCode.OUTPUT_EXISTS, "inspect @scans --output @report", "table.csv", "--force");
        assertThat(report.resolve("table.csv")).hasContent("mine");
    }
}
