package sunbeam.app.files.output;

import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.BufferedWriter;
import java.io.OutputStreamWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.app.terminal.Messages.HarmlessWriter;
import sunbeam.precompute.text.Text;

/** Writer of comma-separated text; numbers have 13 significant digits in scientific notation, NaN or Infinity. */
public final class CsvWriter {
    // Spreadsheets run a cell that begins so as a formula; numbers, also several of them, are none.
    private static final Pattern FORMULA = Pattern.compile("(?s)[=+\\-@\t](?!Infinity$)(?![0-9.][-+0-9.eE; to]*$).*");

    private static final MathContext DIGITS = new MathContext(13, RoundingMode.HALF_UP);

    private CsvWriter() {}

    /**
     * Returns a table of at least one row, all with the same columns, quoted where necessary. Texts that spreadsheets would take for a
     * formula get an apostrophe in front; control characters other than line feeds become their numbers after a backslash and u.
     */
    public static String text(List<? extends Map<String, ?>> rows) {
        return text(List.copyOf(rows.get(0).keySet()), rows);
    }

    /** Returns a table, perhaps without rows, all of which have these columns in this order. */
    public static String text(List<String> columns, List<? extends Map<String, ?>> rows) {
        StringWriter text = new StringWriter();
        var csv = de.siegmar.fastcsv.writer.CsvWriter.builder()
                .lineDelimiter(LineDelimiter.LF)
                .bufferSize(0)
                .build(text);
        csv.writeRecord(columns);
        rows.forEach(row ->
                csv.writeRecord(row.values().stream().map(CsvWriter::cell).toList()));
        return text.toString();
    }

    private static String cell(Object value) {
        String text = HarmlessWriter.CONTROLLING
                .matcher(String.valueOf(value))
                .replaceAll(control ->
                        Text.format("\\\\u%04x", (int) control.group().charAt(0)));
        return FORMULA.matcher(text).matches() ? "'" + text : text;
    }

    /** Returns a table of numbers, row by row from 0. The names have letters, digits, {@code _ . -} and blanks only. */
    public static StreamContent numbers(List<String> names, int rows, IntFunction<double[]> row) {
        return numbers(names, Set.of(), rows, row);
    }

    /** Returns a table of numbers, those of some columns as integers. */
    public static StreamContent numbers(List<String> names, Set<String> integers, int rows, IntFunction<double[]> row) {
        return stream -> {
            Writer writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.UTF_8));
            writer.write(String.join(",", names) + "\n");
            for (int number = 0; number < rows; number++) {
                double[] values = row.apply(number);
                writer.write(IntStream.range(0, values.length)
                        .mapToObj(column -> cell(values[column], integers.contains(names.get(column))))
                        .collect(Collectors.joining(",", "", "\n")));
            }
            writer.flush();
        };
    }

    private static String cell(double value, boolean whole) {
        if (whole) {
            return Long.toString((long) value);
        }
        if (value == 0 || !Double.isFinite(value)) {
            return value == 0 ? Text.format("%.12e", value) : Double.toString(value);
        }
        // The text of format "%.12e", in a tenth of its time.
        BigDecimal rounded = new BigDecimal(Double.toString(Math.abs(value))).round(DIGITS);
        String digits = rounded.unscaledValue().toString();
        int exponent = digits.length() - 1 - rounded.scale();
        String zeros = "0".repeat(DIGITS.getPrecision() - digits.length());
        return (value < 0 ? "-" : "") + digits.charAt(0) + "." + digits.substring(1) + zeros
                + (exponent < 0 ? "e-" : "e+") + (Math.abs(exponent) < 10 ? "0" : "") + Math.abs(exponent);
    }
}
