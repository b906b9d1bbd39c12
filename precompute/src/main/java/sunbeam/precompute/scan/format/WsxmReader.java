package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * WSxM .stp and .top: a text header whose size it states, then 16-bit integers, floats or doubles, little-endian, from
 * the bottom right. "Z Amplitude" is the height between the lowest and the highest sample. Source: the header itself,
 * which WSxM keeps readable, and files.
 */
final class WsxmReader implements ScanReader {
    private static final Pattern SIZE = Pattern.compile("Image header size:\\s*(\\d{1,7})");

    @Override
    public String format() {
        return "WSxM";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith("WSxM file copyright") && file.headText(300).contains("SxM Image file");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        Matcher size = SIZE.matcher(file.headText(300));
        if (!size.find()) {
            throw new ScanException("does not say how long its header is; save it with a newer WSxM");
        }
        int start = Integer.parseInt(size.group(1));
        file.requireInside(start, 0);
        Header values = Header.of(file.headText(start), ':');
        int columns = values.count("Number of columns");
        int rows = values.count("Number of rows");
        SampleType type = type(values.text("Image Data Type", "short"));
        ScanChannel.Source samples = SampleBlock.of(file, start, (long) columns * rows, type, ByteOrder.LITTLE_ENDIAN)
                .mirrored(columns)
                .upsideDown(columns);
        Header.Quantity amplitude = values.quantity("Z Amplitude");
        String name = values.text("Acquisition channel", values.text("Head type", ""));
        return List.of(new ScanChannel(
                name,
                columns,
                rows,
                new Extent(values.metres("X Amplitude", ""), values.metres("Y Amplitude", ""), 1),
                amplitude.unit(),
                () -> stretched(samples.read(), amplitude.value())));
    }

    private static SampleType type(String name) {
        return switch (name) {
            case "short" -> SampleType.SIGNED_16;
            case "float" -> SampleType.FLOAT_32;
            case "double" -> SampleType.FLOAT_64;
            default ->
                throw new ScanException(
                        String.format(Locale.ROOT, "stores samples as \"%s\"; save it with doubles", name));
        };
    }

    /** Samples in units of which the lowest and the highest are an amplitude apart; zero stays zero. */
    private static double[] stretched(double[] samples, double amplitude) {
        double least = Double.POSITIVE_INFINITY;
        double largest = Double.NEGATIVE_INFINITY;
        for (double sample : samples) {
            least = Math.min(least, sample);
            largest = Math.max(largest, sample);
        }
        return largest > least ? Samples.scaled(samples, amplitude / (largest - least), 0) : samples;
    }
}
