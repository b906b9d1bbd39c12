package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import sunbeam.precompute.text.Text;

/**
 * Reader of Bruker (Digital Instruments, Veeco) Nanoscope files since version 4.2: lists of {@code \key: value}, one per image, then
 * little-endian integers from the bottom row. A height is sample * "Z scale" (volts of the full range) / steps of the range * a sensitivity
 * (nm/V) of another list. Source: manual of the Nanoscope software, "File format", and sample files.
 */
final class NanoscopeReader {
    private static final Pattern LINE = Pattern.compile("\\\\@?(?:\\d+:)?\\s*([^:]+):\\s*(.*)");
    /** Such as {@code V [Sens. Zsens] (0.0050354 V/LSB) 329.995 V}; the name and the unit may be missing; log(Pa) is a unit. */
    private static final Pattern SCALE =
            Pattern.compile("V\\s*(?:\\[([^\\]]*)\\])?\\s*(?:\\(.*\\))?\\s*([-+0-9.eE]+)\\s*(\\S*)\\s*");

    private static final Pattern SENSITIVITY = Pattern.compile("V\\s+([-+0-9.eE]++)\\s*+([^/\\s]+)/V.*");
    private static final int LONGEST_SCALE = 200;
    private static final Pattern NAME = Pattern.compile("S\\s*(?:\\[([^\\]]*)\\])?\\s*\"?([^\"]*)\"?\\s*");

    private NanoscopeReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        ScanException.refuseIf(
                file.startsWith("\\*Force"),
                "holds force curves and no scan; export its height channel as an image file");
        Header common = new Header();
        List<Header> images = new ArrayList<>();
        Header list = common;
        List<String> lines = file.headText(Header.LARGEST)
                .lines()
                .takeWhile(line -> !line.matches("\\\\\\*.{0,9}File list end.*"))
                .toList();
        for (String line : lines) {
            Matcher matcher = LINE.matcher(line);
            if (line.startsWith("\\*") && line.toLowerCase(Locale.ROOT).contains("image list")) {
                list = new Header();
                images.add(list);
            } else if (line.startsWith("\\*")) {
                list = common;
            } else if (matcher.matches()) {
                list.put(matcher.group(1).strip().toLowerCase(Locale.ROOT), matcher.group(2));
            }
        }
        return images.stream().map(image -> channel(file, common, image)).toList();
    }

    private static ScanChannel channel(ScanBytes file, Header common, Header image) {
        Stored stored = Stored.of(common, image);
        Header.Quantity scale = scale(common, image);
        double perStep = scale.value() / Math.pow(256, image.count("bytes/pixel"));
        long skipped = (long) stored.firstRow * stored.columns * stored.type.size();
        Samples samples =
                Samples.of(file, image.count("data offset") + skipped, stored.columns, stored.rows, stored.type);
        return new ScanChannel(
                name(image),
                image.text("line direction", "").equalsIgnoreCase("retrace"),
                samples.flipRows().scale(perStep, 0),
                extent(common, image, samples),
                scale.unit());
    }

    /** Valid samples; a stopped scan stores fewer lines than announced. */
    private record Stored(int columns, int firstRow, int rows, SampleType type) {
        static Stored of(Header common, Header image) {
            int columns = image.count("samps/line");
            int rows = image.count("number of lines");
            long length = image.count("data length");
            // Since version 9.2 samples have 32 bits, while "Bytes/pixel" still gives the number of steps of "Z scale".
            for (int bytes : new int[] {image.count("bytes/pixel"), Integer.BYTES}) {
                for (int lines : new int[] {rows, lines(image, "valid data len y"), lines(common, "lines")}) {
                    if (lines > 0 && lines <= rows && (long) columns * lines * bytes == length) {
                        return new Stored(columns, 0, lines, SampleType.signed(8 * bytes)).valid(image);
                    }
                }
            }
            throw new ScanException("has " + length + " bytes for " + columns + " x " + rows
                    + " samples; the file is damaged, copy or export it again");
        }

        private Stored valid(Header image) {
            double firstColumn = image.number("valid data start x", 0);
            double validColumns = image.number("valid data len x", columns);
            double first = image.number("valid data start y", 0);
            double valid = image.number("valid data len y", rows);
            // A stopped scan may store its valid lines alone.
            double skipped = valid == rows ? 0 : first;
            if (firstColumn != 0
                    || validColumns != columns
                    || !(skipped >= 0 && valid >= 1 && skipped + valid <= rows)
                    || skipped != Math.rint(skipped)
                    || valid != Math.rint(valid)) {
                throw new ScanException(Text.format(
                        "has valid data of %.0f x %.0f samples from column %.0f and line %.0f on in %d x %d;"
                                + " export the valid part alone",
                        validColumns, valid, firstColumn, first, columns, rows));
            }
            return new Stored(columns, (int) skipped, (int) valid, type);
        }

        private static int lines(Header list, String key) {
            return list.has(key) ? list.count(key) : 0;
        }
    }

    private static String name(Header image) {
        Matcher name = NAME.matcher(image.text("image data", ""));
        if (!name.matches()) {
            return "";
        }
        return name.group(1) == null || name.group(1).isBlank() ? name.group(2) : name.group(1);
    }

    private static Header.Quantity scale(Header common, Header image) {
        String text = image.text("z scale", "");
        ScanException.refuseIf(
                !text.startsWith("V"),
                "has no \"Z scale\" with volts, as before Nanoscope 4.2; save it with a newer version"
                        + " or as .gwy with Gwyddion");
        Matcher scale = SCALE.matcher(text.length() <= LONGEST_SCALE ? text : "");
        if (!scale.matches()) {
            return new Header.Quantity(1, "unknown unit");
        }
        double value = number(scale.group(2));
        String unit = scale.group(3);
        String name = scale.group(1) == null ? "" : scale.group(1).toLowerCase(Locale.ROOT);
        Matcher sensitivity = SENSITIVITY.matcher(common.text(name, ""));
        if (!List.of("", "V", "mV").contains(unit) || !sensitivity.matches()) {
            return new Header.Quantity(value, unit);
        }
        double perVolt = unit.equals("mV") ? 1e-3 : 1;
        return new Header.Quantity(value * perVolt * number(sensitivity.group(1)), sensitivity.group(2));
    }

    private static double number(String text) {
        return Header.Quantity.of(text)
                .filter(quantity -> quantity.unit().isEmpty())
                .orElseThrow(() -> new ScanException("has a scale that is no number; the file is damaged"))
                .value();
    }

    /**
     * Parses "500 500 nm", "500 nm" or "10 5 ~m" (micrometers), the size of the complete scan. If both sides are equal or one is missing, the
     * height follows from the aspect ratio (width over height, "2:1" or "2"), or else from square pixels.
     */
    private static Extent extent(Header common, Header image, Samples samples) {
        String[] words = image.text("scan size", common.text("scan size", "")).split("\\s+", -1);
        Optional<Double> meters = Extent.metersPer(words[words.length - 1]);
        if (words.length < 2 || words.length > 3 || meters.isEmpty()) {
            return Extent.UNKNOWN;
        }
        double width = number(words[0]) * meters.get();
        double second = number(words[words.length - 2]) * meters.get();
        int lines = image.count("number of lines");
        String aspect = image.text("aspect ratio", common.text("aspect ratio", ""));
        double square = words.length == 2 ? width * lines / samples.columns() : width;
        double height = second != width ? second : aspect.isEmpty() ? square : width / ratio(aspect);
        return Extent.of(width, height * samples.rows() / lines);
    }

    private static double ratio(String text) {
        double[] sides = Stream.of(text.split("\\s*:\\s*", -1))
                .mapToDouble(side -> Header.Quantity.of(side)
                        .filter(number -> number.unit().isEmpty())
                        .map(Header.Quantity::value)
                        .orElse(0.0))
                .toArray();
        double ratio = sides.length > 2 ? 0 : sides.length == 2 ? sides[0] / sides[1] : sides[0];
        ScanException.refuseIf(
                !(ratio > 0) || Double.isInfinite(ratio),
                "has an aspect ratio of " + Text.quoted(text) + "; the file is damaged, export it again");
        return ratio;
    }
}
