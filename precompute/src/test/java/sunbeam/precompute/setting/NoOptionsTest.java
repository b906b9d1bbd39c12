package sunbeam.precompute.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tables know no options of command lines: a {@link Setting}'s name depends on the place. */
class NoOptionsTest {
    private static final Path SOURCES = Path.of("src", "main", "java");
    private static final Pattern COMMENT = Pattern.compile("/\\*.*?\\*/|(?m)^\\s*//.*$", Pattern.DOTALL);
    /** A character or a text within a line, so that a quotation mark as a character, or an apostrophe in a comment, opens no text. */
    private static final Pattern LITERAL = Pattern.compile("'(?:\\\\.|[^'\\\\\n])++'|\"(?:\\\\.|[^\"\\\\\n])*+\"");

    private static final Pattern OPTION = Pattern.compile("(?<![\\w-])--[a-z]");

    @Test
    void noTextNamesAnOption() throws IOException {
        List<String> named = new ArrayList<>();
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".java")).toList()) {
                named.addAll(options(Files.readString(file)));
            }
        }
        // An option of Gwyddion.
        named.remove("\"--convert-to-gwy=\"");
        assertThat(named).isEmpty();
    }

    private static List<String> options(String source) {
        return LITERAL.matcher(COMMENT.matcher(source).replaceAll(""))
                .results()
                .map(MatchResult::group)
                .filter(OPTION.asPredicate())
                .toList();
    }
}
