package sunbeam.app.commands.color;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import sunbeam.app.terminal.Messages;

/** What the user should know of the surfaces: a line for each, and all of it with {@code --explain} and in the JSON. */
final class Remarks {
    private final Map<String, List<String>> warnings = new LinkedHashMap<>();

    void add(String surface, String warning) {
        warnings.computeIfAbsent(surface, name -> new ArrayList<>()).add(warning);
    }

    /** In full, each led by its surface. */
    List<String> all() {
        return warnings.entrySet().stream()
                .flatMap(entry -> entry.getValue().stream().map(warning -> entry.getKey() + ": " + warning))
                .toList();
    }

    /** @param explained whether all is asked for, else what each warning begins with */
    void print(boolean explained, PrintWriter err) {
        if (explained) {
            all().forEach(warning -> err.println(Messages.warning(warning)));
        } else {
            warnings.forEach((surface, all) -> err.println(Messages.warning(surface + ": "
                    + all.stream().map(Remarks::beginning).collect(Collectors.joining("; "))
                    + " (--explain says more)")));
        }
        err.flush();
    }

    private static String beginning(String warning) {
        int colon = warning.indexOf(": ");
        return colon < 0 ? warning : warning.substring(0, colon);
    }
}
