package sunbeam.app.cli.options;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.StandardOutput;

/** Option {@code --json}, which prints the report as JSON in place of text; a picocli mixin. */
public final class JsonOption {
    @Option(
            names = "--json",
            description = "Print the report as one JSON object, for programs; lengths are in meters (_m), angles in"
                    + " degrees (_deg), times in seconds (_s). Fields may be added in later versions, but keep their"
                    + " names and units (docs/reference/report.schema.json).")
    private boolean asked;

    public boolean isGiven() {
        return asked;
    }

    /** Returns the stream for lines of text: with {@code --json} one that drops them. */
    public PrintWriter text(PrintWriter out) {
        return asked ? new PrintWriter(Writer.nullWriter()) : out;
    }

    /** Prints the names of written files, or with {@code --json} the report as one JSON object with them. */
    public void print(PrintWriter out, Map<String, ?> report, List<Path> files) {
        List<String> names = files.stream().map(StandardOutput::name).toList();
        if (asked) {
            Map<String, Object> all = new LinkedHashMap<>(report);
            all.put("files", names);
            print(out, all);
        } else {
            names.forEach(out::println);
        }
    }

    public static void print(PrintWriter out, Map<String, ?> report) {
        out.println(text(report));
    }

    /** Returns a report as one JSON object in the map's order; infinities and NaN become strings, as JSON has no numbers for them. */
    public static String text(Map<String, ?> report) {
        try {
            return new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT).writeValueAsString(report);
        } catch (JsonProcessingException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
