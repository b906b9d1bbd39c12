package sunbeam.app.cli.options;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.PrintWriter;
import java.util.Map;
import picocli.CommandLine.Option;

/** Option {@code --json}, which prints the report as JSON in place of text; a picocli mixin. */
public final class JsonOption {
    @Option(
            names = "--json",
            description = "Print the report as one JSON object, for programs; lengths are in metres. Fields may be"
                    + " added in later versions, but keep their names and units.")
    private boolean asked;

    public boolean isAsked() {
        return asked;
    }

    /** Prints a report as one JSON object. */
    public static void print(PrintWriter out, Map<String, ?> report) {
        out.println(text(report));
    }

    /**
     * Returns a report as one JSON object.
     *
     * @param report numbers, texts, booleans, lists and further maps by name, printed in the map's order; infinities and NaN become
     *     strings, as JSON has no numbers for them
     */
    public static String text(Map<String, ?> report) {
        try {
            return new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT).writeValueAsString(report);
        } catch (JsonProcessingException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
