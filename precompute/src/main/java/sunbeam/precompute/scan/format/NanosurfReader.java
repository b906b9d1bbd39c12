package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of .nid files by Nanosurf: sections of {@code key=value}, {@code #!}, then the channels' samples by group, from the bottom row. A
 * sample s of b bits means {@code Dim2Min + Dim2Range (s / 2^b + 1/2)}. Source: Nanosurf, "NID file format", and sample files.
 */
final class NanosurfReader {
    private static final String MARK = "#!";
    private static final int MOST_GROUPS = 64;
    private static final int MOST_PER_GROUP = 64;

    private NanosurfReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        String head = file.headBefore(MARK);
        Map<String, Header> sections = sections(head);
        Header set = sections.getOrDefault("DataSet", new Header());
        List<ScanChannel> channels = new ArrayList<>();
        long offset = (long) head.length() + MARK.length();
        int groups = Math.min(MOST_GROUPS, set.count("GroupCount"));
        for (int group = 0; group < groups; group++) {
            for (int number = 0; number < MOST_PER_GROUP; number++) {
                Header section = sections.get(set.text("Gr" + group + "-Ch" + number, ""));
                if (section != null) {
                    offset += add(channels, file, section, offset);
                }
            }
        }
        return channels;
    }

    private static Map<String, Header> sections(String header) {
        Map<String, Header> sections = new TreeMap<>();
        Header section = new Header();
        for (String line : header.lines().toList()) {
            int equals = line.indexOf('=');
            if (line.startsWith("[") && line.endsWith("]")) {
                String path = line.substring(1, line.length() - 1);
                section = new Header();
                sections.putIfAbsent(path.startsWith("DataSet\\") ? path.substring(8) : path, section);
            } else if (equals > 0) {
                section.put(line.substring(0, equals), line.substring(equals + 1));
            }
        }
        return sections;
    }

    /** Returns the bytes of the channel's samples. */
    private static long add(List<ScanChannel> channels, ScanBytes file, Header section, long offset) {
        int bits = section.count("SaveBits");
        String mode = section.text("SaveMode", "Binary");
        String sign = section.text("SaveSign", "Signed");
        if (!mode.equals("Binary") || !sign.equals("Signed")) {
            throw new ScanException("stores samples as " + mode + ", " + sign + "; export it in another format");
        }
        boolean little = section.text("SaveOrder", "Intel").equals("Intel");
        SampleType type = SampleType.signed(bits);
        Samples samples = Samples.of(
                file,
                offset,
                section.count("Points"),
                section.count("Lines"),
                type,
                little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        String unit = section.text("Dim0Unit", "");
        if (section.text("Dim1Unit", "").equals(unit)) {
            double range = section.number("Dim2Range");
            double middle = section.number("Dim2Min") + 0.5 * range;
            boolean backward = section.text("Frame", "").contains("backward");
            channels.add(new ScanChannel(
                    section.text("Dim2Name", "") + (backward ? " backward" : " forward"),
                    backward,
                    samples.flipRows().scale(range / Math.pow(2, bits), middle),
                    Extent.ofSides(section.number("Dim0Range"), section.number("Dim1Range"), unit, samples),
                    section.text("Dim2Unit", "")));
        }
        return samples.count() * type.size();
    }
}
