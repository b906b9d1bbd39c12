package sunbeam.precompute.scan;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import sunbeam.precompute.scan.TextReader.TextNumbers;

/** Readers of the file formats of ISO 25178, parts 71 and 72. */
final class SurfaceDataReaders {
    private static final int BINARY_HEADER_BYTES = 81;
    private static final Map<Integer, SampleType> SDF_TYPES = Map.of(
            0, SampleType.UNSIGNED_8,
            1, SampleType.UNSIGNED_16,
            2, SampleType.UNSIGNED_32,
            3, SampleType.FLOAT_32,
            4, SampleType.SIGNED_8,
            5, SampleType.SIGNED_16,
            6, SampleType.SIGNED_32,
            7, SampleType.FLOAT_64);

    private static final String MAIN = "main.xml";
    // Bytes; known files have a few thousand.
    private static final int LARGEST_MAIN = 1 << 20;

    private static final Map<String, SampleType> X3P_TYPES = Map.of(
            "I", SampleType.SIGNED_16,
            "L", SampleType.SIGNED_32,
            "F", SampleType.FLOAT_32,
            "D", SampleType.FLOAT_64);

    private SurfaceDataReaders() {}

    static boolean isSdf(ScanBytes file) throws IOException {
        return file.headText(8).matches("[ab](ISO|BCR)-\\d\\.\\d");
    }

    /**
     * Reads .sdf files of ISO 25178-71, text ("aISO-1.0") and binary ("bISO-1.0"), and of BCR-1.0. Xscale and Yscale are pitches in meters;
     * a height in meters is sample * Zscale. Missing samples are BAD in text, the lowest integer or NaN in binary files.
     */
    static List<ScanChannel> sdf(ScanBytes file) throws IOException {
        return List.of(file.startsWith("a") ? text(file) : binary(file));
    }

    private static ScanChannel text(ScanBytes file) throws IOException {
        String head = file.headBefore("*");
        Header values = Header.of(head, '=');
        requireUncompressed((int) values.number("Compression", 0));
        long line = head.lines().count() + 1;
        int columns = values.count("NumPoints");
        int rows = values.count("NumProfiles");
        Samples samples = new Samples(columns, rows, () -> {
            int count = Math.multiplyExact(columns, rows);
            Reader numbers = new InputStreamReader(file.stream(head.length() + 1L), StandardCharsets.ISO_8859_1);
            return new TextNumbers(new BufferedReader(numbers), false, TextFile.REMOVE, line, count).first(count);
        });
        return channel(samples, values.number("Xscale"), values.number("Yscale"), values.number("Zscale"));
    }

    private static ScanChannel binary(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(8 + 10 + 12 + 12, ByteOrder.LITTLE_ENDIAN);
        int columns = cursor.unsigned16();
        int rows = cursor.unsigned16();
        double pitchX = cursor.float64();
        double pitchY = cursor.float64();
        double scale = cursor.float64();
        cursor.float64();
        requireUncompressed(cursor.unsignedByte());
        SampleType type = SampleType.of(SDF_TYPES, cursor.unsignedByte());
        double missing = switch (type) {
            case SIGNED_16 -> Short.MIN_VALUE;
            case SIGNED_32 -> Integer.MIN_VALUE;
            default -> Double.NaN;
        };
        Samples stored = Samples.of(file, BINARY_HEADER_BYTES, columns, rows, type);
        return channel(stored.withMissing(missing), pitchX, pitchY, scale);
    }

    private static ScanChannel channel(Samples samples, double pitchX, double pitchY, double scale) {
        return new ScanChannel(
                "Topography", samples.scale(scale, 0), Extent.ofPitches(pitchX, pitchY, "m", samples), "m");
    }

    private static void requireUncompressed(int compression) {
        ScanException.refuseIf(
                compression != 0, "is compressed, which this reader does not support; export it without compression");
    }

    static boolean isX3p(ScanBytes file) throws IOException {
        if (!file.startsWith("PK\u0003\u0004")) {
            return false;
        }
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            return archive.getEntry(MAIN) != null;
        } catch (IOException | IllegalArgumentException broken) {
            return false;
        }
    }

    /**
     * Reads .x3p files of ISO 25178-72: a zip archive with main.xml and binary samples, from the top row, in meters. Missing ones are NaN,
     * or have a 0 in a list of valid points. No more of a member is read than the matrix takes, so that an archive cannot unpack to terabytes.
     */
    static List<ScanChannel> x3p(ScanBytes file) throws IOException {
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            Header main = main(member(archive, MAIN, 0));
            ScanException.refuseIf(
                    !main.text("CX/AxisType", "I").equals("I")
                            || !main.text("CY/AxisType", "I").equals("I"),
                    "holds points on no grid; interpolate them and export a matrix");
            ScanException.refuseIf(
                    main.number("MatrixDimension/SizeZ", 1) != 1, "holds several layers; export one of them");
            int columns = main.count("MatrixDimension/SizeX");
            int rows = main.count("MatrixDimension/SizeY");
            Samples.requireSize(columns, rows);
            SampleType type = SampleType.of(X3P_TYPES, main.text("CZ/DataType", "D"));
            String points = main.find("DataLink/PointDataLink")
                    .orElseThrow(() -> new ScanException("has its samples in main.xml; export them as binary data"));
            member(archive, points, (long) columns * rows * type.size()).close();
            Optional<String> valid = main.find("DataLink/ValidPointsLink");
            Samples samples = new Samples(columns, rows, () -> x3pSamples(file, columns * rows, type, points, valid));
            Samples heights = samples.scale(main.number("CZ/Increment", 1), main.number("CZ/Offset", 0));
            Extent extent = Extent.ofPitches(main.number("CX/Increment"), main.number("CY/Increment"), "m", samples);
            return List.of(new ScanChannel("Topography", heights, extent, "m"));
        } catch (IOException damaged) {
            throw broken(damaged);
        }
    }

    /** Returns elements' texts under the keys parent/name. */
    private static Header main(InputStream in) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newInstance();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        Header header = new Header();
        Deque<String> path = new ArrayDeque<>(List.of(""));
        StringBuilder text = new StringBuilder();
        try (in) {
            XMLStreamReader xml = factory.createXMLStreamReader(new ByteArrayInputStream(in.readNBytes(LARGEST_MAIN)));
            while (xml.hasNext()) {
                int event = xml.next();
                if (event == XMLStreamConstants.START_ELEMENT) {
                    path.push(xml.getLocalName());
                    text.setLength(0);
                } else if (event == XMLStreamConstants.CHARACTERS) {
                    text.append(xml.getText());
                } else if (event == XMLStreamConstants.END_ELEMENT) {
                    String name = path.pop();
                    header.put(path.element() + "/" + name, text.toString());
                    text.setLength(0);
                }
            }
        } catch (XMLStreamException invalid) {
            throw new ScanException(
                    "has a main.xml that is no valid XML, or longer than 1 MB; export it again", invalid);
        }
        return header;
    }

    private static InputStream member(ZipFile archive, String name, long bytes) throws IOException {
        ZipEntry entry = archive.getEntry(name);
        if (entry == null || entry.isDirectory() || entry.getSize() < bytes) {
            throw new ScanException("has " + (entry == null ? "no" : entry.getSize()) + " bytes of " + name
                    + ", where its matrix takes " + bytes + "; copy or export it again");
        }
        return archive.getInputStream(entry);
    }

    private static double[] x3pSamples(
            ScanBytes file, int count, SampleType type, String points, Optional<String> valid) throws IOException {
        try (ZipFile archive = new ZipFile(file.path().toFile());
                InputStream in = member(archive, points, (long) count * type.size())) {
            double[] samples = type.read(in, count, ByteOrder.LITTLE_ENDIAN);
            if (valid.isPresent()) {
                // One bit per sample, the lowest bit of a byte first; 0 marks a missing sample.
                try (InputStream list = member(archive, valid.get(), 0)) {
                    byte[] bits = list.readNBytes((count + 7) / 8);
                    IntStream.range(0, Math.min(count, Byte.SIZE * bits.length))
                            .filter(i -> (bits[i / 8] >> i % 8 & 1) == 0)
                            .forEach(i -> samples[i] = Double.NaN);
                }
            }
            return samples;
        } catch (IOException damaged) {
            throw broken(damaged);
        }
    }

    private static ScanException broken(IOException damaged) {
        return new ScanException(
                "is a damaged archive (" + damaged.getMessage() + "); copy or export it again", damaged);
    }
}
