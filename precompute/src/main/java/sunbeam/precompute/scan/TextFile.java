package sunbeam.precompute.scan;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import sunbeam.precompute.scan.TextReader.TextNumbers;

/**
 * Text file with numbers: its header, encoding and decimal mark.
 *
 * @param charset UTF-16 by its byte order mark, else UTF-8 if the first bytes are valid in it, else Latin-1
 * @param remedy for a word that is no number
 * @param ambiguity what makes the decimal mark unknown, if it is and none is chosen
 */
record TextFile(
        ScanBytes file,
        Charset charset,
        List<String> header,
        boolean decimalComma,
        String remedy,
        Optional<String> ambiguity) {
    /** Remedy for a word of a file whose decimal mark is known. */
    static final String REMOVE = "remove it, or export the scan again";

    private static final int LONGEST_HEADER = 1 << 18;

    private static final Pattern NUMBER =
            Pattern.compile("[+\u2212-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eEdD][+\u2212-]?\\d{1,3})?|[+-]?[nN][aA][nN]");
    // Commas are decimal marks between digits, never before a sign, if others separate the numbers.
    private static final Pattern FRACTION = Pattern.compile("\\d,\\d");
    private static final Pattern SIGNED = Pattern.compile(",[-+\u2212]");
    private static final Pattern SEPARATED = Pattern.compile("\\S[ \\t]+\\S|;");
    // Keys of ESRI's ASCII grids.
    private static final Pattern GRID_COLUMNS = Pattern.compile("(?i)\\s*ncols\\s+\\d.*");
    private static final Pattern NO_DATA = Pattern.compile("(?i)\\s*nodata_value\\s+(\\S{1,30})\\s*");

    /** Recognizes a text by a line of numbers in its first 256 KB; an empty mark is detected. */
    static Optional<TextFile> of(ScanBytes file, Optional<TextReader.DecimalMark> mark) throws IOException {
        byte[] bytes = file.head(LONGEST_HEADER);
        Charset charset = charset(bytes);
        String head = withoutCutWord(new String(bytes, charset), bytes.length < file.size());
        if (head.isEmpty() || head.chars().anyMatch(c -> c < ' ' && "\t\n\r\f".indexOf(c) < 0)) {
            return Optional.empty();
        }
        List<String> header = new ArrayList<>();
        for (String line : head.lines().toList()) {
            // Commas separate numbers, or are decimal marks within them.
            if (areNumbers(line, " \t;,\"\f\ufeff") || areNumbers(line, " \t;\"\f\ufeff")) {
                String numbers = head.lines().skip(header.size()).collect(Collectors.joining("\n"));
                boolean comma =
                        mark.map(TextReader.DecimalMark.COMMA::equals).orElseGet(() -> hasDecimalCommas(numbers));
                Optional<String> ambiguity = mark.isPresent() ? Optional.empty() : UnknownMark.in(numbers);
                return Optional.of(new TextFile(file, charset, header, comma, remedy(mark), ambiguity));
            }
            header.add(line.startsWith("\ufeff") ? line.substring(1) : line);
        }
        return Optional.empty();
    }

    private static String remedy(Optional<TextReader.DecimalMark> mark) {
        return mark.map(chosen -> switch (chosen) {
                    case POINT -> REMOVE;
                    case COMMA ->
                        "remove it, or export numbers with semicolons between them and no thousands separators";
                })
                .orElse("remove it, or say which mark its decimals have");
    }

    private static boolean areNumbers(String line, String separators) {
        List<Object> words = Collections.list(new StringTokenizer(line, separators));
        return !words.isEmpty()
                && words.stream().allMatch(word -> NUMBER.matcher((String) word).matches());
    }

    private static Charset charset(byte[] head) {
        if (head.length > 1 && (head[0] & 0xff) + (head[1] & 0xff) == 0xff + 0xfe) {
            return head[0] == (byte) 0xff ? StandardCharsets.UTF_16LE : StandardCharsets.UTF_16BE;
        }
        // The first bytes may end within a character.
        boolean broken = StandardCharsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(head), CharBuffer.allocate(head.length), false)
                .isError();
        return broken ? StandardCharsets.ISO_8859_1 : StandardCharsets.UTF_8;
    }

    private static String withoutCutWord(String head, boolean cut) {
        int end = head.length();
        while (cut && end > 0 && " \t;,\r\n".indexOf(head.charAt(end - 1)) < 0) {
            end--;
        }
        return head.substring(0, end);
    }

    private static boolean hasDecimalCommas(String numbers) {
        return numbers.indexOf('.') < 0
                && FRACTION.matcher(numbers).find()
                && SEPARATED.matcher(numbers).find()
                && !SIGNED.matcher(numbers).find();
    }

    /** Throws ScanException if the numbers are none, {@link UnknownMark} if they cannot be told apart. */
    TextNumbers numbers() throws IOException {
        if (ambiguity.isPresent()) {
            throw new UnknownMark(ambiguity.get());
        }
        // A single line, which is held as text, may contain all numbers.
        Samples.requireMemory(0, file.size());
        BufferedReader reader = new BufferedReader(new InputStreamReader(file.stream(0), charset));
        for (int line = 0; line < header.size(); line++) {
            reader.readLine();
        }
        return new TextNumbers(reader, decimalComma, remedy, header.size() + 1L, Long.MAX_VALUE);
    }

    /** Number that stands for a missing sample, in ESRI's grids -9999 unless they state another; NaN if none does. */
    double missing() {
        boolean isGrid =
                header.stream().anyMatch(line -> GRID_COLUMNS.matcher(line).matches());
        return header.stream()
                .map(NO_DATA::matcher)
                .filter(Matcher::matches)
                .flatMap(matcher -> Header.Quantity.of(matcher.group(1)).stream())
                .mapToDouble(Header.Quantity::value)
                .findFirst()
                .orElse(isGrid ? -9999 : Double.NaN);
    }

    /**
     * Facts of a text's header, under the keys of Gwyddion, SPIP, Park's XEI, WSxM, ESRI's grids and Lyncee Tec's DHM.
     *
     * @param side width and height, if they are stated
     * @param factor of the numbers to the unit
     */
    record Facts(
            String channel,
            Optional<Integer> columns,
            Optional<Integer> rows,
            Extent side,
            Optional<Pitches> pitches,
            double factor,
            String unit) {
        /** Distances of columns and of rows, with their units, which may be empty. */
        private record Pitches(Header.Quantity x, Header.Quantity y) {}

        // ESRI writes no sign between key and value.
        private static final Pattern GRID =
                Pattern.compile("(?i)\\s*(ncols|nrows|cellsize|dx|dy|xdim|ydim)\\s+(\\S{1,30})\\s*");
        private static final Pattern SIZE = Pattern.compile("(?i)\\s*h\\s*=\\s*(\\d{1,7})\\s+w\\s*=\\s*(\\d{1,7})\\s*");
        private static final Pattern CONVERSION =
                Pattern.compile("(?i)(?:height|z) conversion factor \\(-> ?(\\S+)\\)");
        private static final Pattern LINE =
                Pattern.compile("[#%;*/\\s\"]*([^:=]{1,60}?)\\s*[:=]\\s*(.{0,200}?)[\\s\"]*");

        private static final List<String> CHANNEL = List.of("channel", "name", "title");
        private static final List<String> COLUMNS =
                List.of("x-pixels", "image width", "columns", "number of columns", "ncols");
        private static final List<String> ROWS = List.of("y-pixels", "image height", "rows", "number of rows", "nrows");
        private static final List<String> WIDTH =
                List.of("width", "real width", "x-length", "x amplitude", "scan size x");
        private static final List<String> HEIGHT =
                List.of("height", "real height", "y-length", "y amplitude", "scan size y");
        private static final List<String> PITCH_X = List.of(
                "x pixel size",
                "pixel size x",
                "pixel size",
                "pixel_size",
                "pixel width",
                "x-pitch",
                "dx",
                "xdim",
                "cellsize");
        private static final List<String> PITCH_Y =
                List.of("y pixel size", "pixel size y", "pixel height", "y-pitch", "dy", "ydim");
        private static final List<String> SIDE_UNIT = List.of("x-unit", "xy-unit", "xyunits", "length unit");
        private static final List<String> UNIT =
                List.of("value units", "z-unit", "z unit", "zunits", "data unit", "height unit", "unit", "units");

        static Facts of(List<String> lines) {
            Header header = new Header();
            List<String> inOrder = new ArrayList<>();
            double factor = 1;
            String converted = "";
            for (String line : lines) {
                Matcher grid = GRID.matcher(line);
                Matcher size = SIZE.matcher(line);
                Matcher matcher = LINE.matcher(line);
                if (grid.matches()) {
                    header.put(grid.group(1).toLowerCase(Locale.ROOT), grid.group(2));
                } else if (size.matches()) {
                    header.put("rows", size.group(1));
                    header.put("columns", size.group(2));
                } else if (matcher.matches()) {
                    header.put(matcher.group(1).toLowerCase(Locale.ROOT), matcher.group(2));
                    inOrder.add(matcher.group(2));
                    Matcher conversion = CONVERSION.matcher(matcher.group(1));
                    if (conversion.matches()) {
                        factor = header.number(matcher.group(1).toLowerCase(Locale.ROOT));
                        converted = conversion.group(1);
                    }
                }
            }
            // SPIP's own files give lengths in nm without a unit.
            boolean spip =
                    lines.stream().anyMatch(line -> line.contains("SPIP") || line.contains("File Format = ASCII"));
            String sideUnit = first(header, SIDE_UNIT).flatMap(header::find).orElse(spip ? "nm" : "");
            Optional<Double> width = first(header, WIDTH).flatMap(key -> header.meters(key, sideUnit));
            Optional<Double> height = first(header, HEIGHT).flatMap(key -> header.meters(key, sideUnit));
            Optional<String> unit = first(header, UNIT).flatMap(header::find);
            String channel = first(header, CHANNEL).flatMap(header::find).orElse("");
            if ((width.isEmpty() || unit.isEmpty()) && inOrder.size() == 4) {
                // Gwyddion's four lines (channel, width, height, unit) have keys in the user's language.
                Optional<Double> second = Header.Quantity.of(inOrder.get(1)).flatMap(some -> some.meters(""));
                Optional<Double> third = Header.Quantity.of(inOrder.get(2)).flatMap(some -> some.meters(""));
                if (second.isPresent() && third.isPresent()) {
                    channel = inOrder.get(0);
                    width = second;
                    height = third;
                    unit = Optional.of(inOrder.get(3));
                }
            }
            return new Facts(
                    channel,
                    first(header, COLUMNS).map(header::count),
                    first(header, ROWS).map(header::count),
                    new Extent(width, height, 1),
                    pitches(header, sideUnit),
                    factor,
                    converted.isEmpty() ? unit.orElse("") : converted);
        }

        private static Optional<Pitches> pitches(Header header, String otherwise) {
            Optional<Header.Quantity> x = first(header, PITCH_X).map(key -> pitch(header, key, otherwise));
            Optional<Header.Quantity> y = first(header, PITCH_Y).map(key -> pitch(header, key, otherwise));
            return x.isEmpty() && y.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new Pitches(x.orElseGet(y::get), y.orElseGet(x::get)));
        }

        private static Header.Quantity pitch(Header header, String key, String otherwise) {
            Header.Quantity stated = header.quantity(key);
            return stated.unit().isEmpty() ? new Header.Quantity(stated.value(), otherwise) : stated;
        }

        boolean areOfMatrix() {
            return side.width().isPresent() || columns.isPresent();
        }

        /** Returns the stated sides; a missing one follows from the pitches, of which the ratio counts if they are not in meters. */
        Extent extent(Samples samples) {
            if (pitches.isEmpty()) {
                return side;
            }
            Header.Quantity x = pitches.get().x();
            Header.Quantity y = pitches.get().y();
            double perX = Extent.metersPer(x.unit()).orElse(1.0);
            double perY = Extent.metersPer(y.unit()).orElse(x.unit().equals(y.unit()) ? perX : 1.0);
            Extent own = Extent.ofPitches(x.value(), y.value() * perY / perX, x.unit(), samples);
            return side.width().isEmpty()
                    ? own
                    : new Extent(side.width(), side.height(), y.value() * perY / (x.value() * perX));
        }

        private static Optional<String> first(Header header, List<String> names) {
            return names.stream().filter(name -> header.find(name).isPresent()).findFirst();
        }
    }
}
