package sunbeam.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.Sunbeam;
import sunbeam.app.terminal.Environment;

/** docs/reference/commands.md is what {@code --help-all} prints. */
class CommandReferenceTest {
    private static final Path PAGE = Path.of("..", "docs", "reference", "commands.md");
    private static final String COMMANDS = "brdf-map render view inspect color evaluate orders reflectance precompute"
            + " export sample figures benchmark compare mesh cache doctor";

    @TempDir
    private Path cache;

    private String help(String... arguments) {
        StringWriter out = new StringWriter();
        int code = new Sunbeam(new Environment(Map.of(), cache), new PrintWriter(out, true), new PrintWriter(out, true))
                .run(arguments);
        assertThat(code).isZero();
        return out.toString().strip();
    }

    /** With {@code -Dsunbeam.update=true} the page is written anew. */
    @Test
    void theReferenceOfTheCommandsIsTheirHelp() throws IOException {
        StringBuilder page = new StringBuilder("""
                # Commands

                What `./sunbeam --help` and `./sunbeam COMMAND --help-all` print. Made by
                `./sunbeam test -Dtest=CommandReferenceTest -Dsunbeam.update=true`.

                """);
        page.append("```text\n").append(help("--help")).append("\n```\n");
        for (String command : COMMANDS.split(" ")) {
            page.append("\n## ").append(command).append("\n\n```text\n");
            page.append(help(command, "--help-all")).append("\n```\n");
        }
        if (Boolean.getBoolean("sunbeam.update")) {
            Files.createDirectories(PAGE.getParent());
            Files.writeString(PAGE, page);
        }
        assertThat(Files.readString(PAGE)).isEqualTo(page.toString());
    }
}
