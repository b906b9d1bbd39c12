package sunbeam.precompute.scan;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** Readers of instruments' own formats: text headers of keys and values before binary samples, and TIFF files with private tags. */
final class InstrumentReaders {
    private static final int KEY_LENGTH = 14;
    private static final Map<String, SampleType> AGILENT_TYPES =
            Map.of("BINARY", SampleType.SIGNED_16, "BINARY_32", SampleType.SIGNED_32);

    private static final String NANOSURF_MARK = "#!";
    private static final int MOST_GROUPS = 64;
    private static final int MOST_PER_GROUP = 64;
    private static final Pattern WSXM_SIZE = Pattern.compile("Image header size:\\s*(\\d{1,7})");

    private static final Map<String, SampleType> WSXM_TYPES =
            Map.of("short", SampleType.SIGNED_16, "float", SampleType.FLOAT_32, "double", SampleType.FLOAT_64);

    // Tags of JPK's files.
    private static final int GRID_WIDTH = 0x8042;
    private static final int GRID_HEIGHT = 0x8043;
    private static final int CHANNEL = 0x8050;
    private static final int RETRACE = 0x8051;
    private static final int CHANNEL_TITLE = 0x8052;
    private static final int SLOTS = 0x8080;
    private static final int DEFAULT_SLOT = 0x8081;
    private static final int FIRST_SLOT = 0x8090;
    private static final int SLOT_STEP = 0x30;
    private static final int MOST_SLOTS = 64;
    // Tags of a slot, relative to its first one, its name.
    private static final int UNIT = 0x12;
    private static final int SCALING = 0x13;
    private static final int MULTIPLIER = 0x14;
    private static final int OFFSET = 0x15;
    private static final int PARK_TAG = 50432;
    private static final int PARK_VERSION = 50433;
    private static final int PARK_DATA = 50434;
    private static final int PARK_HEADER = 50435;
    private static final int PARK_MAGIC = 0x0e031301;
    // Bytes; the last field that is read ends there.
    private static final int LEAST_HEADER = 352;
    private static final int FIRST_VERSION_WITH_TYPES = 0x01000002;
    private static final Map<Integer, SampleType> PARK_TYPES =
            Map.of(0, SampleType.SIGNED_16, 1, SampleType.SIGNED_32, 2, SampleType.FLOAT_32);

    private InstrumentReaders() {}

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
        for (String section : header.split("(?m)^(?=\\[.*\\]$)", -1)) {
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

    /** In some files only the second page has a channel's name. */
    static boolean isJpk(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, GRID_WIDTH) && (TiffPage.has(file, 1, CHANNEL) || TiffPage.has(file, 2, CHANNEL));
    }

    /**
     * Reads JPK (Bruker NanoWizard) images: a thumbnail with the scan's size in its tags, and channels, from the bottom row, with several
     * scalings ("slots"). Source: JPK, "Image file format specification", tags 0x8000 to 0x80ff.
     */
    static List<ScanChannel> jpk(ScanBytes file) throws IOException {
        List<TiffPage> pages = TiffPage.read(file);
        TiffPage grid = pages.get(0);
        Extent extent = Extent.of(grid.number(GRID_WIDTH, 0), grid.number(GRID_HEIGHT, 0));
        return pages.stream().skip(1).map(page -> jpkChannel(page, extent)).toList();
    }

    private static ScanChannel jpkChannel(TiffPage page, Extent extent) {
        String title = page.text(CHANNEL_TITLE);
        int slot = slot(page);
        boolean linear = page.text(slot + SCALING).equals("LinearScaling");
        double factor = linear ? page.number(slot + MULTIPLIER, 0) : 1;
        double offset = linear ? page.number(slot + OFFSET, 0) : 0;
        String name = title.isEmpty() ? page.text(CHANNEL) : title;
        // Samples without a scaling are steps of a converter.
        String unit = linear ? page.text(slot + UNIT) : "steps";
        boolean retrace = page.number(RETRACE, 0) != 0;
        return new ScanChannel(name, retrace, page.samples(0).flipRows().scale(factor, offset), extent, unit);
    }

    private static int slot(TiffPage page) {
        String wanted = page.text(DEFAULT_SLOT);
        return IntStream.range(0, (int) Math.min(MOST_SLOTS, page.number(SLOTS, 0)))
                .map(i -> FIRST_SLOT + SLOT_STEP * i)
                .filter(first -> page.text(first).equals(wanted))
                .findFirst()
                .orElseThrow(() ->
                        new ScanException("has a channel without its scaling \"" + wanted + "\"; export it again"));
    }

    static boolean isPark(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, PARK_TAG) && TiffPage.has(file, 1, PARK_HEADER);
    }

    /**
     * Reads Park Systems' TIFF files: a preview whose private tags hold a header and the samples, from the bottom row. A height is {@code
     * gain (scale sample + offset)}. Source: Park Systems, "TIFF format for XEI", and sample files.
     */
    static List<ScanChannel> park(ScanBytes file) throws IOException {
        TiffPage page = TiffPage.read(file).get(0);
        byte[] data = page.bytes(PARK_DATA);
        byte[] head = page.bytes(PARK_HEADER);
        ByteBuffer header = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN);
        ScanException.refuseIf(
                page.number(PARK_TAG, 0) != PARK_MAGIC || data.length == 0 || head.length < LEAST_HEADER,
                "has no heights in its Park Systems tags; export it again");
        ScanException.refuseIf(
                header.getInt(0) != 0, "holds lines or spectra and no scan; choose the file of the image");
        int columns = header.getInt(100);
        int rows = header.getInt(104);
        boolean forward = header.getInt(128) != 0;
        double gain = header.getDouble(220);
        double scale = header.getDouble(228);
        double offset = gain * header.getDouble(236);
        boolean typed = page.number(PARK_VERSION, 0) >= FIRST_VERSION_WITH_TYPES;
        SampleType type = SampleType.of(PARK_TYPES, typed ? header.getInt(348) : 0);
        Samples.requireSize(columns, rows);
        int count = columns * rows;
        if ((long) count * type.size() > data.length) {
            throw new ScanException("has " + data.length + " bytes of samples where " + columns + " x " + rows
                    + " take " + (long) count * type.size() + "; copy or export it again");
        }
        Samples samples = new Samples(
                columns, rows, () -> type.read(new ByteArrayInputStream(data), count, ByteOrder.LITTLE_ENDIAN));
        Samples heights = samples.flipRows().scale(scale == 0 ? gain : gain * scale, offset);
        Extent extent = Extent.of(1e-6 * header.getDouble(140), 1e-6 * header.getDouble(148));
        return List.of(new ScanChannel(utf16(head, 4, 32), !forward, heights, extent, utf16(head, 244, 8)));
    }

    private static String utf16(byte[] header, int position, int characters) {
        return new String(header, position, 2 * characters, StandardCharsets.UTF_16LE).split("\0", 2)[0];
    }
}
