package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import sunbeam.app.viewer.Action.Group;
import sunbeam.app.viewer.Action.Help;

final class HelpTest {
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
        Set<KeyStroke> seen = new HashSet<>();
        Arrays.stream(Action.values())
                .flatMap(action -> action.strokes().stream())
                .forEach(stroke ->
                        assertThat(seen.add(stroke)).as(String.valueOf(stroke)).isTrue());
        assertThat(seen).doesNotContainNull();
    }
}
