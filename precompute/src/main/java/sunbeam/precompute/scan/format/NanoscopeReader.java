package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Bruker (Digital Instruments, Veeco) Nanoscope, since version 4.2: lists of {@code \key: value}, one list an image;
 * then integers, little-endian, from the bottom row. A height is the sample times "Z scale" (the volts of all steps
 * together) over the number of steps, times a sensitivity (nm/V) that stands in another list. Source: Nanoscope
 * software's manual, "File format", and files.
 */
final class NanoscopeReader {
    private static final Pattern LINE = Pattern.compile("\\\\@?(?:\\d+:)?\\s*([^:]+):\\s*(.*)");
    /** {@code V [Sens. Zsens] (0.0050354 V/LSB) 329.995 V}; sensitivity and unit may be missing. */
    private static final Pattern SCALE =
            Pattern.compile("V\\s*(?:\\[([^\\]]*)\\])?\\s*(?:\\([^)]*\\)?)?\\s*([-+0-9.eE]+)\\s*(\\S*)\\s*");

    private static final Pattern SENSITIVITY = Pattern.compile("V\\s+([-+0-9.eE]+)\\s*(?:([^/\\s]*)/V)?.*");
    private static final Pattern NAME = Pattern.compile("S\\s*(?:\\[([^\\]]*)\\])?\\s*\"?([^\"]*)\"?\\s*");

    private NanoscopeReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("\\*Force")) {
            throw new ScanException("holds force curves and no scan; export its height channel as an image file");
        }
        Header all = new Header();
        List<Header> images = new ArrayList<>();
        Header list = all;
        for (String line : file.headText(Header.LARGEST).lines().toList()) {
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
            throw new ScanException("has " + length + " bytes for " + columns + " x " + rows
                    + " samples; the file is damaged, copy or export it again");
        }
        SampleType type = SampleType.signed((int) Math.min(64, 8 * bytes));
        Header.Quantity scale = scale(all, image);
        double perStep = scale.value() / Math.pow(256, image.count("bytes/pixel"));
        Samples samples = Samples.of(file, offset, columns, rows, type);
        return new ScanChannel(
                name(image),
                image.text("line direction", "").equalsIgnoreCase("retrace"),
                samples.upsideDown().scaled(perStep, 0),
                extent(image.text("scan size", all.text("scan size", "")), samples),
                scale.unit());
    }

    private static String name(Header image) {
        Matcher name = NAME.matcher(image.text("image data", ""));
        if (!name.matches()) {
            return "";
        }
        return name.group(1) == null || name.group(1).isBlank() ? name.group(2) : name.group(1);
    }

    private static Header.Quantity scale(Header all, Header image) {
        Matcher hard = SCALE.matcher(image.text("z scale", ""));
        if (!hard.matches()) {
            throw new ScanException(
                    "has no \"Z scale\" with volts, as before Nanoscope 4.2; save it with a newer version"
                            + " or as .gwy with Gwyddion");
        }
        double volts = number(hard.group(2));
        String unit = hard.group(3);
        String name = hard.group(1) == null ? "" : hard.group(1).toLowerCase(Locale.ROOT);
        Matcher soft = SENSITIVITY.matcher(all.text(name, ""));
        if (!soft.matches() || soft.group(2) == null || soft.group(2).isEmpty()) {
            return new Header.Quantity(volts, unit);
        }
        double perVolt = unit.equals("mV") ? 1e-3 : 1;
        return new Header.Quantity(volts * perVolt * number(soft.group(1)), soft.group(2));
    }

    private static double number(String text) {
        return Header.Quantity.of(text)
                .filter(quantity -> quantity.unit().isEmpty())
                .orElseThrow(() -> new ScanException("has a scale that is no number; the file is damaged"))
                .value();
    }

    /** "500 500 nm", "500 nm", "10 10 ~m". */
    private static Extent extent(String text, Samples samples) {
        String[] words = text.split("\\s+", -1);
        Optional<Double> metres = LengthUnit.metres(words[words.length - 1]);
        if (words.length < 2 || metres.isEmpty()) {
            return Extent.UNKNOWN;
        }
        double width = number(words[0]) * metres.get();
        double height =
                words.length == 3 ? number(words[1]) * metres.get() : width * samples.rows() / samples.columns();
        return Extent.of(width, height);
    }
}
