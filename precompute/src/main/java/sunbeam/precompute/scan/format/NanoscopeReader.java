package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Bruker (Digital Instruments, Veeco) Nanoscope, since version 4.2: lists of {@code \key: value}, one list an image;
 * then integers, little-endian, from the bottom row. A height is the sample times "Z scale" (the volts of all steps
 * together) over the number of steps, times a sensitivity (nm/V) that stands in another list. Source: Nanoscope
 * software's manual, "File format", and files.
 */
final class NanoscopeReader implements ScanReader {
    private static final int LARGEST_HEADER = 1 << 20;
    private static final Pattern LINE = Pattern.compile("\\\\@?(?:\\d+:)?\\s*([^:]+):\\s*(.*)");
    /** {@code V [Sens. Zsens] (0.0050354 V/LSB) 329.995 V}; sensitivity and unit may be missing. */
    private static final Pattern SCALE =
            Pattern.compile("V\\s*(?:\\[([^\\]]*)\\])?\\s*(?:\\([^)]*\\)?)?\\s*([-+0-9.eE]+)\\s*(\\S*)\\s*");

    private static final Pattern SENSITIVITY = Pattern.compile("V\\s+([-+0-9.eE]+)\\s*(?:([^/\\s]*)/V)?.*");
    private static final Pattern NAME = Pattern.compile("S\\s*(?:\\[([^\\]]*)\\])?\\s*\"?([^\"]*)\"?\\s*");

    @Override
    public String format() {
        return "Bruker Nanoscope";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith("\\*File list") || file.startsWith("\\*Force file list");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("\\*Force")) {
            throw new ScanException("holds force curves and no scan; export its height channel as an image file");
        }
        Header all = new Header();
        List<Header> images = new ArrayList<>();
        Header list = all;
        for (String line : file.headText(LARGEST_HEADER).lines().toList()) {
            if (line.startsWith("\\*File list end")) {
                break;
            }
            Matcher matcher = LINE.matcher(line);
            if (line.startsWith("\\*")) {
                boolean image = line.toLowerCase(Locale.ROOT).contains("image list");
                list = image ? new Header() : all;
                if (image) {
                    images.add(list);
                }
            } else if (matcher.matches()) {
                list.put(matcher.group(1).strip().toLowerCase(Locale.ROOT), matcher.group(2));
            }
        }
        List<ScanChannel> channels = new ArrayList<>();
        for (Header image : images) {
            channels.add(channel(file, all, image));
        }
        return channels;
    }

    private static ScanChannel channel(ScanBytes file, Header all, Header image) {
        int columns = image.count("samps/line");
        int rows = image.count("number of lines");
        long offset = image.count("data offset");
        long length = image.count("data length");
        long count = (long) columns * rows;
        // Since version 9.2 samples have 32 bits, while "Bytes/pixel" still tells how many steps "Z scale" is about.
        long bytes = length / count;
        if (bytes * count != length) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d bytes for %d x %d samples; the file is damaged, copy or export it again",
                    length,
                    columns,
                    rows));
        }
        SampleType type = SampleType.signed((int) Math.min(64, 8 * bytes));
        Scale scale = scale(all, image);
        double perStep = scale.value / Math.pow(256, image.count("bytes/pixel"));
        return new ScanChannel(
                name(image),
                direction(image.text("line direction", "")),
                columns,
                rows,
                extent(all, image, columns, rows),
                scale.unit,
                SampleBlock.of(file, offset, count, type, ByteOrder.LITTLE_ENDIAN)
                        .upsideDown(columns)
                        .scaled(perStep, 0));
    }

    private static String name(Header image) {
        Matcher name = NAME.matcher(image.text("image data", ""));
        if (!name.matches()) {
            return "";
        }
        return name.group(1) == null || name.group(1).isBlank() ? name.group(2) : name.group(1);
    }

    private static Direction direction(String word) {
        return switch (word.toLowerCase(Locale.ROOT)) {
            case "trace" -> Direction.TRACE;
            case "retrace" -> Direction.RETRACE;
            default -> Direction.UNKNOWN;
        };
    }

    /** What all steps of a sample are worth together. */
    private record Scale(double value, String unit) {}

    private static Scale scale(Header all, Header image) {
        Matcher hard = SCALE.matcher(image.text("z scale", ""));
        if (!hard.matches()) {
            throw new ScanException(
                    "has no \"Z scale\" with volts, as before Nanoscope 4.2; save it with a newer version"
                            + " or as .gwy with Gwyddion");
        }
        double volts = number(hard.group(2));
        String unit = hard.group(3);
        Optional<Matcher> soft = Optional.ofNullable(hard.group(1))
                .map(name -> SENSITIVITY.matcher(all.text(name.toLowerCase(Locale.ROOT), "")))
                .filter(Matcher::matches)
                .filter(matcher -> matcher.group(2) != null && !matcher.group(2).isEmpty());
        if (soft.isEmpty()) {
            return new Scale(volts, unit);
        }
        double perVolt = unit.equals("mV") ? 1e-3 : 1;
        return new Scale(
                volts * perVolt * number(soft.get().group(1)), soft.get().group(2));
    }

    private static double number(String text) {
        return Header.number(Optional.of(text))
                .orElseThrow(() -> new ScanException("has a scale that is no number; the file is damaged"));
    }

    /** "500 500 nm", "500 nm", "10 10 ~m": of the image, else of the scan. */
    private static Extent extent(Header all, Header image, int columns, int rows) {
        String text = image.text("scan size", all.text("scan size", ""));
        String[] words = text.split("\\s+", -1);
        boolean both = words.length == 3;
        if (words.length < 2) {
            return Extent.UNKNOWN;
        }
        Optional<Double> metres = LengthUnit.metres(words[words.length - 1]);
        if (metres.isEmpty()) {
            return Extent.UNKNOWN;
        }
        double width = number(words[0]) * metres.get();
        double height = both ? number(words[1]) * metres.get() : width * rows / columns;
        return Extent.of(width, height);
    }
}
