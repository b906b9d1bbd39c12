package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The thesis's figures as a folder with a page. */
class FiguresTest {
    private static final String DRAW = "figures --only 5.5,4.9 --size 24 --output f";

    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeEach
    void layOut() throws Exception {
        workplace = Workplace.in(root);
    }

    @Test
    void aRunDrawsTheFiguresAskedForAndTheNextKeepsThem() throws Exception {
        SunbeamResult first = workplace.succeed(DRAW.split(" ", -1));

        assertThat(first.stdout()).isEqualTo("f/index.html\n");
        String page = Files.readString(workplace.resolve("f/index.html"));
        assertThat(page)
                .contains("Figure 5.5", "5.5-blaze-10nm.png", "CIEDE2000", "Figure 4.9", "4.9-blaze-response.png")
                .doesNotContain("Figure 5.10");
        assertThat(workplace.resolve("f/4.9-blaze-response.json")).exists();
        FileTime written = Files.getLastModifiedTime(workplace.resolve("f/5.5-blaze-full-0.png"));

        SunbeamResult second = workplace.succeed(DRAW.split(" ", -1));

        assertThat(second.stderr()).isEmpty();
        assertThat(Files.getLastModifiedTime(workplace.resolve("f/5.5-blaze-full-0.png")))
                .isEqualTo(written);
        assertThat(Files.readString(workplace.resolve("f/index.html"))).isEqualTo(page);
    }

    @Test
    void otherPicturesAndPagesAreNotOverwritten() throws Exception {
        Path folder = Files.createDirectory(workplace.resolve("f"));
        Files.writeString(folder.resolve("index.html"), "mine");

        Complaint.assertThatIt(
                workplace.command(DRAW.split(" ", -1)).run(),
                Complaint.OUTPUT_EXISTS,
                "cannot write f/index.html: it exists and is no page of figures; add --force");
        Files.delete(folder.resolve("index.html"));
        Files.writeString(folder.resolve("5.5-blaze-full-0.png"), "mine");
        Complaint.assertThatIt(
                workplace.command(DRAW.split(" ", -1)).run(),
                Complaint.OUTPUT_EXISTS,
                "cannot write f/5.5-blaze-full-0.png: it exists, with other parameters; add --force");
        assertThat(folder.resolve("5.5-blaze-full-0.png")).hasContent("mine");
        assertThat(folder).isDirectoryNotContaining(file -> file.toString().endsWith(".part"));
    }

    @Test
    void aFigureThatIsNoneAndAFolderWithoutPatches() throws Exception {
        Complaint.assertThatIt(
                workplace.command("figures", "--only", "6.1").run(), Complaint.USAGE, "--only 6.1: no such figure");
        Complaint.assertThatIt(
                workplace.command("figures", "--patches", ".").run(), Complaint.USAGE, "there is no blaze.json");
        assertThat(workplace.files()).isEmpty();
    }
}
