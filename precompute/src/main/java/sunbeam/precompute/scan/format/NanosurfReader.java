package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.HeaderText;

/**
 * Nanosurf: sections of {@code key=value}; the mark {@code #!}; the channels' samples one after the other in the order
 * of the groups, from the bottom row. A sample of b bits stands for {@code Dim2Min + Dim2Range (s / 2^b + 1/2)}. Source:
 * Nanosurf, "NID file format", and files.
 */
final class NanosurfReader implements ScanReader {
    private static final int LARGEST_HEADER = 1 << 20;
    private static final int MOST_GROUPS = 64;
    private static final int MOST_PER_GROUP = 64;

    @Override
    public String format() {
        return "Nanosurf (.nid)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith("[DataSet]");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        String head = file.headText(LARGEST_HEADER);
        int mark = head.indexOf("#!");
        if (mark < 0) {
            throw new ScanException("has no samples after its header; copy or export it again");
        }
        Map<String, Map<String, String>> sections = sections(head.substring(0, mark));
        Map<String, String> set = sections.getOrDefault("DataSet", Map.of());
        List<ScanChannel> channels = new ArrayList<>();
        long offset = mark + 2L;
        int groups = Math.min(MOST_GROUPS, HeaderText.integer(set, "GroupCount"));
        for (int group = 0; group < groups; group++) {
            for (int number = 0; number < MOST_PER_GROUP; number++) {
                String name = set.get(String.format(Locale.ROOT, "Gr%d-Ch%d", group, number));
                Map<String, String> section = name == null ? null : sections.get(name);
                if (section != null) {
                    offset += add(channels, file, section, offset);
                }
            }
        }
        return channels;
    }

    private static Map<String, Map<String, String>> sections(String header) {
        Map<String, Map<String, String>> sections = new TreeMap<>();
        Map<String, String> section = new HashMap<>();
        for (String line : header.lines().toList()) {
            int equals = line.indexOf('=');
            if (line.startsWith("[") && line.endsWith("]")) {
                String path = line.substring(1, line.length() - 1);
                section = new HashMap<>();
                sections.putIfAbsent(path.startsWith("DataSet\\") ? path.substring(8) : path, section);
            } else if (equals > 0) {
                section.putIfAbsent(
                        line.substring(0, equals).strip(),
                        line.substring(equals + 1).strip());
            }
        }
        return sections;
    }

    /** Adds a channel of an image; its bytes. */
    private static long add(List<ScanChannel> channels, ScanBytes file, Map<String, String> section, long offset) {
        int columns = HeaderText.integer(section, "Points");
        int rows = HeaderText.integer(section, "Lines");
        int bits = HeaderText.integer(section, "SaveBits");
        String mode = section.getOrDefault("SaveMode", "Binary");
        String sign = section.getOrDefault("SaveSign", "Signed");
        if (!mode.equals("Binary") || !sign.equals("Signed")) {
            throw new ScanException(
                    String.format(Locale.ROOT, "stores samples as %s, %s; export it in another format", mode, sign));
        }
        ByteOrder order = section.getOrDefault("SaveOrder", "Intel").equals("Intel")
                ? ByteOrder.LITTLE_ENDIAN
                : ByteOrder.BIG_ENDIAN;
        SampleBlock block =
                new SampleBlock(offset, (long) columns * rows, SampleType.signed(bits), order).requireIn(file);
        boolean image = section.getOrDefault("Dim1Unit", "").equals(section.get("Dim0Unit"));
        if (image) {
            double range = HeaderText.number(section, "Dim2Range");
            double least = HeaderText.number(section, "Dim2Min");
            double perStep = range / Math.pow(2, bits);
            String frame = section.getOrDefault("Frame", "");
            boolean backward = frame.contains("backward");
            Extent extent = Extent.ofPitches(
                    HeaderText.number(section, "Dim0Range") / columns,
                    HeaderText.number(section, "Dim1Range") / rows,
                    section.get("Dim0Unit"),
                    columns,
                    rows);
            channels.add(new ScanChannel(
                    section.getOrDefault("Dim2Name", "") + (backward ? " backward" : " forward"),
                    backward ? Direction.RETRACE : Direction.TRACE,
                    columns,
                    rows,
                    extent,
                    section.getOrDefault("Dim2Unit", ""),
                    () -> Samples.scaled(Samples.upsideDown(block.read(file), columns), perStep, least + 0.5 * range)));
        }
        return block.bytes();
    }
}
