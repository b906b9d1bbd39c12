package sunbeam.precompute.scan.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.text.Quoted;

/**
 * What the header of a text says about its numbers.
 *
 * @param channel name; empty when it does not say
 * @param columns numbers of a row, if said
 * @param rows if said
 * @param width metres, if said
 * @param height metres, if said
 * @param unit of the numbers as written; empty when it does not say
 */
record TextFacts(
        String channel,
        Optional<Integer> columns,
        Optional<Integer> rows,
        Optional<Double> width,
        Optional<Double> height,
        String unit) {
    private static final Pattern LINE = Pattern.compile("[#%;*/\\s\"]*([^:=]{1,60}?)\\s*[:=]\\s*(.{0,200}?)[\\s\"]*");

    private static final Set<String> CHANNEL = Set.of("channel", "kanal", "canal", "name", "title");
    private static final Set<String> COLUMNS = Set.of(
            "x-pixels",
            "x pixels",
            "image width",
            "columns",
            "number of columns",
            "xres",
            "samples/line",
            "samps/line");
    private static final Set<String> ROWS = Set.of(
            "y-pixels", "y pixels", "image height", "rows", "lines", "number of rows", "number of lines", "yres");
    private static final Set<String> WIDTH = Set.of(
            "width",
            "breite",
            "largeur",
            "real width",
            "x-length",
            "x length",
            "x amplitude",
            "xreal",
            "x-range",
            "x range",
            "x scan size",
            "scan size x");
    private static final Set<String> HEIGHT = Set.of(
            "height",
            "h\u00f6he",
            "hoehe",
            "hauteur",
            "real height",
            "y-length",
            "y length",
            "y amplitude",
            "yreal",
            "y-range",
            "y range",
            "y scan size",
            "scan size y");
    private static final Set<String> SIDE_UNIT =
            Set.of("x-unit", "x unit", "xy-unit", "xy unit", "xyunits", "length unit", "xunits");
    private static final Set<String> UNIT = Set.of(
            "value units",
            "value unit",
            "z-unit",
            "z unit",
            "zunit",
            "z units",
            "zunits",
            "data unit",
            "height unit",
            "units",
            "unit");

    /** @throws ScanException when a size is said that is none */
    static TextFacts of(List<String> header) {
        Map<String, String> values = new HashMap<>();
        List<String> inOrder = new ArrayList<>();
        for (String line : header) {
            Matcher matcher = LINE.matcher(line);
            if (matcher.matches()) {
                values.putIfAbsent(matcher.group(1).strip().toLowerCase(Locale.ROOT), matcher.group(2));
                inOrder.add(matcher.group(2));
            }
        }
        boolean spip = header.stream().anyMatch(line -> line.contains("SPIP") || line.contains("File Format = ASCII"));
        // SPIP's own files give lengths in nm and do not say so.
        String sideUnit = first(values, SIDE_UNIT).orElse(spip ? "nm" : "");
        TextFacts facts = new TextFacts(
                first(values, CHANNEL).orElse(""),
                count(values, COLUMNS),
                count(values, ROWS),
                first(values, WIDTH).flatMap(text -> metres(text, sideUnit)),
                first(values, HEIGHT).flatMap(text -> metres(text, sideUnit)),
                first(values, UNIT).orElse(""));
        return facts.width.isPresent() && !facts.unit.isEmpty() ? facts : facts.orInOrder(inOrder);
    }

    /** Gwyddion translates the names of its four lines, but not their order: channel, width, height, unit. */
    private TextFacts orInOrder(List<String> values) {
        boolean four = values.size() == 4
                && metres(values.get(1), "").isPresent()
                && metres(values.get(2), "").isPresent();
        return four
                ? new TextFacts(
                        values.get(0),
                        columns,
                        rows,
                        metres(values.get(1), ""),
                        metres(values.get(2), ""),
                        values.get(3))
                : this;
    }

    private static Optional<String> first(Map<String, String> values, Set<String> names) {
        return values.entrySet().stream()
                .filter(entry -> names.contains(entry.getKey()))
                .map(Map.Entry::getValue)
                .filter(value -> !value.isBlank())
                .findFirst();
    }

    private static Optional<Integer> count(Map<String, String> values, Set<String> names) {
        return first(values, names).map(text -> {
            OptionalDouble number = HeaderText.number(text);
            double value = number.orElse(0);
            if (value < 1 || value > Integer.MAX_VALUE || value != Math.rint(value)) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "says %s in its header for the size of its rows or columns; mend the header",
                        Quoted.of(text)));
            }
            return (int) value;
        });
    }

    private static Optional<Double> metres(String text, String otherwise) {
        return HeaderText.quantity(text)
                .flatMap(quantity -> LengthUnit.metres(quantity.unit().isEmpty() ? otherwise : quantity.unit())
                        .map(metres -> metres * quantity.value()));
    }
}
