package sunbeam.precompute.scan.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;

/** Facts that a text's header states about its numbers, under the keys that Gwyddion, SPIP, Park's XEI and WSxM write; empty if unknown. */
record TextFacts(String channel, Optional<Integer> columns, Optional<Integer> rows, Extent extent, String unit) {
    private static final Pattern LINE = Pattern.compile("[#%;*/\\s\"]*([^:=]{1,60}?)\\s*[:=]\\s*(.{0,200}?)[\\s\"]*");

    private static final List<String> CHANNEL = List.of("channel", "name", "title");
    private static final List<String> COLUMNS = List.of("x-pixels", "image width", "columns", "number of columns");
    private static final List<String> ROWS = List.of("y-pixels", "image height", "rows", "number of rows");
    private static final List<String> WIDTH = List.of("width", "real width", "x-length", "x amplitude", "scan size x");
    private static final List<String> HEIGHT =
            List.of("height", "real height", "y-length", "y amplitude", "scan size y");
    private static final List<String> SIDE_UNIT = List.of("x-unit", "xy-unit", "xyunits", "length unit");
    private static final List<String> UNIT =
            List.of("value units", "z-unit", "z unit", "zunits", "data unit", "height unit", "unit", "units");

    /** @throws sunbeam.precompute.scan.ScanException if a size is malformed */
    static TextFacts of(List<String> lines) {
        Header header = new Header();
        List<String> inOrder = new ArrayList<>();
        for (String line : lines) {
            Matcher matcher = LINE.matcher(line);
            if (matcher.matches()) {
                header.put(matcher.group(1).toLowerCase(Locale.ROOT), matcher.group(2));
                inOrder.add(matcher.group(2));
            }
        }
        // SPIP's own files give lengths in nm without a unit.
        boolean spip = lines.stream().anyMatch(line -> line.contains("SPIP") || line.contains("File Format = ASCII"));
        String sideUnit = first(header, SIDE_UNIT).flatMap(header::find).orElse(spip ? "nm" : "");
        Optional<Double> width = first(header, WIDTH).flatMap(key -> header.meters(key, sideUnit));
        Optional<Double> height = first(header, HEIGHT).flatMap(key -> header.meters(key, sideUnit));
        Optional<String> unit = first(header, UNIT).flatMap(header::find);
        if (width.isEmpty() || unit.isEmpty()) {
            Optional<TextFacts> translated = inOrder(inOrder);
            if (translated.isPresent()) {
                return translated.get();
            }
        }
        return new TextFacts(
                first(header, CHANNEL).flatMap(header::find).orElse(""),
                first(header, COLUMNS).map(header::count),
                first(header, ROWS).map(header::count),
                new Extent(width, height, 1),
                unit.orElse(""));
    }

    /** Gwyddion's four lines (channel, width, height, unit) have keys in the user's language. */
    private static Optional<TextFacts> inOrder(List<String> values) {
        if (values.size() != 4) {
            return Optional.empty();
        }
        Optional<Double> width = Header.Quantity.of(values.get(1)).flatMap(some -> some.meters(""));
        Optional<Double> height = Header.Quantity.of(values.get(2)).flatMap(some -> some.meters(""));
        return width.isPresent() && height.isPresent()
                ? Optional.of(new TextFacts(
                        values.get(0), Optional.empty(), Optional.empty(), new Extent(width, height, 1), values.get(3)))
                : Optional.empty();
    }

    private static Optional<String> first(Header header, List<String> names) {
        return names.stream().filter(name -> header.find(name).isPresent()).findFirst();
    }
}
