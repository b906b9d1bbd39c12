package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.Action.Group;
import sunbeam.app.viewer.Action.Help;
import sunbeam.app.viewer.FileActions.RecentFiles;

/** Keys and the manual about them, and the list of the files loaded last. */
final class ActionsTest {
    @Test
    void theManualHasTheSameRowsInTheSameGroups() throws Exception {
        String manual = Files.readString(Path.of("../docs/viewer.md"));
        String table = Arrays.stream(Group.values())
                .map(group -> "| **" + group.title + "** | |\n"
                        + Help.rows(group).stream()
                                .map(row -> "| " + row.input() + " | " + row.description() + " |\n")
                                .collect(Collectors.joining()))
                .collect(Collectors.joining());
        assertThat(manual).contains(table);
    }

    @Test
    void aKeyDoesOneThing() {
        assertThat(Arrays.stream(Action.values()).flatMap(action -> action.strokes().stream()))
                .doesNotContainNull()
                .doesNotHaveDuplicates();
    }

    @TempDir
    private Path folder;

    private RecentFiles recent() {
        return RecentFiles.of(new Environment(Map.of(), folder));
    }

    private Path file(String name) throws Exception {
        return Files.writeString(folder.resolve(name), "");
    }

    @Test
    void theLastEightFilesAreListedOnceTheNewestFirst() throws Exception {
        assertThat(recent().files()).isEmpty();
        for (int i = 0; i < 10; i++) {
            recent().add(file(i + ".json"));
        }
        recent().add(file("4.json"));
        Files.delete(file("7.json"));
        assertThat(recent().files().stream().map(file -> file.getFileName().toString()))
                .containsExactly("4.json", "9.json", "8.json", "6.json", "5.json", "3.json", "2.json");
    }

    @Test
    void aDamagedListIsAnEmptyOne() throws Exception {
        recent().add(file("a.json"));
        Files.write(recent().list(), new byte[] {(byte) 0xff, 0, 10});
        assertThat(recent().files()).isEmpty();
        Files.writeString(recent().list(), "relative.json\n" + folder + "\n");
        assertThat(recent().files()).isEmpty();
        recent().add(file("b.json"));
        assertThat(recent().files()).containsExactly(file("b.json"));
    }
}
