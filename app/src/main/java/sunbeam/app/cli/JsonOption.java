package sunbeam.app.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.analysis.WaveLimit;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.ScanFault;

/** Option {@code --json}, which prints the report as JSON in place of text; a picocli mixin. */
public final class JsonOption {
    @Option(
            names = "--json",
            description = "Print the report as one JSON object, for programs; lengths are in meters (_m), angles in"
                    + " degrees (_deg), times in seconds (_s). Fields may be added in later versions, but keep their"
                    + " names and units (docs/reference/report.schema.json).")
    private boolean asked;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /** Refuses a command line whose report and file both go to standard output, before any file is read. */
    public static void requireOneStream(ParseResult parsed) {
        for (String output : List.of("--output", "--linear", "--picture")) {
            boolean isStream =
                    parsed.matchedOptionValue(output, null) instanceof Path file && OutputFolder.isStandardOutput(file);
            if (isStream && parsed.hasMatchedOption("--json")) {
                throw new ParameterException(
                        parsed.commandSpec().commandLine(),
                        "--json and " + output + " - both want standard output; name a file, or leave out --json");
            }
        }
    }

    public boolean isGiven() {
        return asked;
    }

    /** Returns the stream for lines of text: with {@code --json} one that drops them. */
    public PrintWriter text(PrintWriter out) {
        return asked ? new PrintWriter(Writer.nullWriter()) : out;
    }

    /** Prints the names of written files, or with {@code --json} the report as one JSON object with them. */
    public void print(PrintWriter out, Map<String, ?> report, List<Path> files) {
        List<String> names = files.stream().map(OutputFolder::name).toList();
        if (asked) {
            Map<String, Object> all = withCommand(report);
            all.put("files", names);
            out.println(text(all));
        } else {
            names.forEach(out::println);
        }
    }

    /** Returns a report that begins with the command's name, by which docs/reference/report.schema.json knows its fields. */
    public Map<String, Object> withCommand(Map<String, ?> report) {
        return withCommand(command.name(), report);
    }

    public static Map<String, Object> withCommand(String command, Map<String, ?> report) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("command", command);
        all.putAll(report);
        return all;
    }

    /** Returns a report as one JSON object in the map's order; infinities and NaN become strings, as JSON has no numbers for them. */
    public static String text(Map<String, ?> report) {
        try {
            return new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT).writeValueAsString(report);
        } catch (JsonProcessingException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Returns verdict, period and faults of a surface: lengths in meters, angles in degrees; null for values that are unknown. */
    public static Map<String, Object> fields(Patch patch, GratingPeriod period, Verdict verdict) {
        boolean sure = period.isSure();
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", patch.name());
        fields.put("source", patch.source());
        fields.put("verdict_code", verdict.code().label());
        fields.put("verdict", verdict.sentence());
        fields.put("period_m", sure ? period.period() : null);
        fields.put("period_low_m", sure ? period.low() : null);
        fields.put("period_high_m", sure ? period.high() : null);
        fields.put("period_probability", sure ? GratingPeriod.PROBABILITY : null);
        fields.put("direction_deg", sure && period.hasDirection() ? Math.toDegrees(period.azimuth()) : null);
        fields.put(
                "direction_half_width_deg",
                sure && period.hasDirection() ? Math.toDegrees(period.azimuthHalfWidth()) : null);
        fields.put("periods_in_the_scan", sure && !period.isExact() ? period.periods() : null);
        fields.put("share_of_variance", sure ? period.share() : null);
        fields.put("period_not_told", sure ? null : period.reason());
        fields.put(
                "excluded_amplitude_m", period.limit().map(WaveLimit::amplitude).orElse(null));
        fields.put(
                "excluded_periods_m",
                period.limit()
                        .map(limit -> List.of(limit.shortest(), limit.longest()))
                        .orElse(null));
        fields.put("about_m", period.isSeen() ? period.period() : null);
        fields.put("directions_deg", period.isSeen() ? period.directions() : List.of());
        fields.put(
                "first_orders_deg",
                verdict.firstOrders().stream()
                        .map(band -> List.of(hundredths(band.blue()), hundredths(band.red())))
                        .toList());
        fields.put("faults", patch.faults().stream().map(ScanFault::line).toList());
        fields.put(
                "notes",
                Stream.concat(patch.notes().stream(), period.caution(patch).stream())
                        .toList());
        fields.put("warnings", patch.warnings());
        return fields;
    }

    private static double hundredths(double degrees) {
        return Math.rint(100 * degrees) / 100;
    }

    /** Returns relative errors; their number alone if there are none. */
    public static Map<String, Object> fields(ErrorStatistics errors) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("count", errors.count());
        if (errors.count() > 0) {
            fields.put("median", errors.median());
            fields.put("percentile_95", errors.percentile95());
            fields.put("maximum", errors.maximum());
        }
        return fields;
    }

    public static Map<String, Object> fields(Certificate certificate) {
        Map<String, Object> fields = fields(certificate.relative());
        fields.put("missed", certificate.missed());
        fields.put("summary", certificate.summary());
        return fields;
    }
}
