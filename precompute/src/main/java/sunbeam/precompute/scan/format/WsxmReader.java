package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of .stp and .top files by WSxM: a text header that states its length, then little-endian samples from the bottom right corner. "Z
 * Amplitude" is the highest minus the lowest sample. Source: sample files.
 */
final class WsxmReader {
    private static final Pattern SIZE = Pattern.compile("Image header size:\\s*(\\d{1,7})");

    private static final Map<String, SampleType> TYPES =
            Map.of("short", SampleType.SIGNED_16, "float", SampleType.FLOAT_32, "double", SampleType.FLOAT_64);

    private WsxmReader() {}

    static boolean recognizes(ScanBytes file) throws IOException {
        return file.startsWith("WSxM file copyright") && file.headText(300).contains("SxM Image file");
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        Matcher size = SIZE.matcher(file.headText(300));
        if (!size.find()) {
            throw new ScanException("does not say how long its header is; save it with a newer WSxM");
        }
        int start = Integer.parseInt(size.group(1));
        file.requireInside(start, 0);
        Header values = Header.of(file.headText(start), ':');
        SampleType type = SampleType.of(TYPES, values.text("Image Data Type", "short"));
        Samples stored =
                Samples.of(file, start, values.count("Number of columns"), values.count("Number of rows"), type);
        Header.Quantity amplitude = values.quantity("Z Amplitude");
        return List.of(new ScanChannel(
                values.text("Acquisition channel", values.text("Head type", "")),
                stretched(stored.flipColumns().flipRows(), amplitude.value()),
                new Extent(values.meters("X Amplitude", ""), values.meters("Y Amplitude", ""), 1),
                amplitude.unit()));
    }

    private static Samples stretched(Samples stored, double amplitude) {
        return stored.mapAll(samples -> {
            DoubleSummaryStatistics range = Arrays.stream(samples).summaryStatistics();
            double relief = range.getMax() - range.getMin();
            return relief > 0
                    ? Arrays.stream(samples)
                            .map(sample -> sample * (amplitude / relief))
                            .toArray()
                    : samples;
        });
    }
}
