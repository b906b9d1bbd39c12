package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Readers of files with a text header of keys and values, and binary samples after it. */
final class TextHeaderReaders {
    private static final int KEY_LENGTH = 14;
    private static final Map<String, SampleType> AGILENT_TYPES =
            Map.of("BINARY", SampleType.SIGNED_16, "BINARY_32", SampleType.SIGNED_32);

    private static final String NANOSURF_MARK = "#!";
    private static final int MOST_GROUPS = 64;
    private static final int MOST_PER_GROUP = 64;
    private static final Pattern WSXM_SIZE = Pattern.compile("Image header size:\\s*(\\d{1,7})");

    private static final Map<String, SampleType> WSXM_TYPES =
            Map.of("short", SampleType.SIGNED_16, "float", SampleType.FLOAT_32, "double", SampleType.FLOAT_64);

    private TextHeaderReaders() {}

    /**
     * Reads .mi files (Molecular Imaging, Agilent, Keysight): lines of a key padded to 14 characters and a value. The key bufferLabel
     * begins a channel; after the line "data" come the channels' little-endian integers, from the bottom row, whose full range stands for
     * -bufferRange to bufferRange. Source: sample files.
     */
    static List<ScanChannel> agilent(ScanBytes file) throws IOException {
        Header common = new Header();
        List<Header> buffers = new ArrayList<>();
        String head = file.headText(Header.LARGEST);
        int position = 0;
        while (!common.has("data")) {
            int end = head.indexOf('\n', position);
            ScanException.refuseIf(end < 0, "has no line \"data\" after its header; copy or export it again");
            String line = head.substring(position, end);
            String key = line.substring(0, Math.min(KEY_LENGTH, line.length())).strip();
            if (key.equals("bufferLabel")) {
                buffers.add(new Header());
            }
            boolean ofBuffer = !buffers.isEmpty() && !key.equals("data");
            Header list = ofBuffer ? buffers.get(buffers.size() - 1) : common;
            list.put(key, line.length() > KEY_LENGTH ? line.substring(KEY_LENGTH) : "");
            position = end + 1;
        }
        SampleType type = SampleType.of(AGILENT_TYPES, common.text("data", ""));
        Extent extent = Extent.of(common.number("xLength"), common.number("yLength"));
        List<ScanChannel> channels = new ArrayList<>();
        long offset = position;
        for (Header buffer : buffers) {
            Samples samples = Samples.of(file, offset, common.count("xPixels"), common.count("yPixels"), type);
            double factor = buffer.number("bufferRange") / Math.pow(2, 8.0 * type.size() - 1);
            channels.add(new ScanChannel(
                    buffer.text("bufferLabel", ""),
                    buffer.text("direction", "").equals("Retrace"),
                    samples.flipRows().scale(factor, 0),
                    extent,
                    buffer.text("bufferUnit", "")));
            offset += samples.count() * type.size();
        }
        return channels;
    }

    /**
     * Reads .nid files by Nanosurf: sections of {@code key=value}, {@code #!}, then the channels' samples by group, from the bottom row. A
     * sample s of b bits means {@code Dim2Min + Dim2Range (s / 2^b + 1/2)}. Source: Nanosurf, "NID file format", and sample files.
     */
    static List<ScanChannel> nanosurf(ScanBytes file) throws IOException {
        String head = file.headBefore(NANOSURF_MARK);
        Map<String, Header> sections = sections(head);
        Header set = sections.getOrDefault("DataSet", new Header());
        List<ScanChannel> channels = new ArrayList<>();
        long offset = (long) head.length() + NANOSURF_MARK.length();
        int groups = Math.min(MOST_GROUPS, set.count("GroupCount"));
        for (int group = 0; group < groups; group++) {
            for (int number = 0; number < MOST_PER_GROUP; number++) {
                Header section = sections.get(set.text("Gr" + group + "-Ch" + number, ""));
                if (section != null) {
                    offset += addNanosurf(channels, file, section, offset);
                }
            }
        }
        return channels;
    }

    private static Map<String, Header> sections(String header) {
        Map<String, Header> sections = new TreeMap<>();
        for (String section : header.split("(?m)^(?=\\[.*\\]$)")) {
            String path = section.lines().findFirst().orElse("").replaceAll("^\\[(DataSet\\\\)?|\\]$", "");
            sections.putIfAbsent(path, Header.of(section, '='));
        }
        return sections;
    }

    /** Returns the bytes of the channel's samples. */
    private static long addNanosurf(List<ScanChannel> channels, ScanBytes file, Header section, long offset) {
        int bits = section.count("SaveBits");
        String form = section.text("SaveMode", "Binary") + ", " + section.text("SaveSign", "Signed");
        ScanException.refuseIf(
                !form.equals("Binary, Signed"), "stores samples as " + form + "; export it in another format");
        boolean little = section.text("SaveOrder", "Intel").equals("Intel");
        ByteOrder order = little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        SampleType type = SampleType.signed(bits);
        Samples samples = Samples.of(file, offset, section.count("Points"), section.count("Lines"), type, order);
        String unit = section.text("Dim0Unit", "");
        if (section.text("Dim1Unit", "").equals(unit)) {
            double range = section.number("Dim2Range");
            double middle = section.number("Dim2Min") + 0.5 * range;
            boolean backward = section.text("Frame", "").contains("backward");
            String name = section.text("Dim2Name", "") + (backward ? " backward" : " forward");
            Samples heights = samples.flipRows().scale(range / Math.pow(2, bits), middle);
            Extent extent = Extent.ofSides(section.number("Dim0Range"), section.number("Dim1Range"), unit, samples);
            channels.add(new ScanChannel(name, backward, heights, extent, section.text("Dim2Unit", "")));
        }
        return samples.count() * type.size();
    }

    static boolean isWsxm(ScanBytes file) throws IOException {
        return file.startsWith("WSxM file copyright") && file.headText(300).contains("SxM Image file");
    }

    /**
     * Reads .stp and .top files by WSxM: a text header that states its length, then little-endian samples from the bottom right corner. "Z
     * Amplitude" is the highest minus the lowest sample. Source: sample files.
     */
    static List<ScanChannel> wsxm(ScanBytes file) throws IOException {
        Matcher size = WSXM_SIZE.matcher(file.headText(300));
        ScanException.refuseIf(!size.find(), "does not say how long its header is; save it with a newer WSxM");
        int start = Integer.parseInt(size.group(1));
        file.requireInside(start, 0);
        Header values = Header.of(file.headText(start), ':');
        SampleType type = SampleType.of(WSXM_TYPES, values.text("Image Data Type", "short"));
        Samples stored =
                Samples.of(file, start, values.count("Number of columns"), values.count("Number of rows"), type);
        Header.Quantity amplitude = values.quantity("Z Amplitude");
        String name = values.text("Acquisition channel", values.text("Head type", ""));
        Samples heights = stored.flipColumns().flipRows().mapAll(samples -> {
            DoubleSummaryStatistics range = Arrays.stream(samples).summaryStatistics();
            double relief = range.getMax() - range.getMin();
            double factor = relief > 0 ? amplitude.value() / relief : 1;
            Arrays.setAll(samples, i -> factor * samples[i]);
            return samples;
        });
        Extent extent = new Extent(values.meters("X Amplitude", ""), values.meters("Y Amplitude", ""), 1);
        return List.of(new ScanChannel(name, heights, extent, amplitude.unit()));
    }
}
