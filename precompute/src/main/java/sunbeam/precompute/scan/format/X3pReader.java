package sunbeam.precompute.scan.format;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.scan.ScanReader;

/**
 * ISO 25178-72 .x3p: a zip archive with main.xml and the samples as a binary member, from the top row, metres. Only the
 * members that main.xml needs are opened, inside the archive, and never more of them than the size of the matrix asks
 * for: an archive that unpacks to terabytes is not unpacked. NaN and, where there is a list of valid points, its zeros
 * mark missing samples.
 */
final class X3pReader implements ScanReader {
    private static final String MAIN = "main.xml";
    /** Bytes of main.xml; it has a few thousand. */
    private static final int LARGEST_MAIN = 1 << 20;

    @Override
    public String format() {
        return "ISO 25178-72 (.x3p)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        if (!file.startsWith("PK\u0003\u0004")) {
            return false;
        }
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            return archive.getEntry(MAIN) != null;
        } catch (IOException | IllegalArgumentException broken) {
            return false;
        }
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        try (ZipFile archive = new ZipFile(file.path().toFile())) {
            Header main = main(member(archive, MAIN, 0));
            if (!main.text("CX/AxisType", "I").equals("I")
                    || !main.text("CY/AxisType", "I").equals("I")) {
                throw new ScanException("holds points on no grid; interpolate them and export a matrix");
            }
            if (main.number("MatrixDimension/SizeZ", 1) != 1) {
                throw new ScanException("holds several layers; export one of them");
            }
            int columns = main.count("MatrixDimension/SizeX");
            int rows = main.count("MatrixDimension/SizeY");
            ScanLimits.requireSize(columns, rows);
            SampleType type = type(main.text("CZ/DataType", "D"));
            SampleBlock block = new SampleBlock(0, (long) columns * rows, type, ByteOrder.LITTLE_ENDIAN);
            String points = main.find("DataLink/PointDataLink")
                    .orElseThrow(() -> new ScanException("has its samples in main.xml; export them as binary data"));
            member(archive, points, block.bytes()).close();
            Extent extent =
                    Extent.ofPitches(main.number("CX/Increment"), main.number("CY/Increment"), "m", columns, rows);
            ScanChannel.Source samples = () -> samples(file, block, points, main.find("DataLink/ValidPointsLink"));
            return List.of(new ScanChannel(
                    "Topography",
                    columns,
                    rows,
                    extent,
                    "m",
                    samples.scaled(main.number("CZ/Increment", 1), main.number("CZ/Offset", 0))));
        } catch (IOException damaged) {
            throw broken(damaged);
        }
    }

    /** The texts of elements, as parent/name. */
    private static Header main(InputStream in) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newInstance();
        // No reference to anything outside is followed.
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

    private static SampleType type(String code) {
        return switch (code) {
            case "I" -> SampleType.SIGNED_16;
            case "L" -> SampleType.SIGNED_32;
            case "F" -> SampleType.FLOAT_32;
            case "D" -> SampleType.FLOAT_64;
            default -> throw new ScanException("stores samples of the unknown type " + code + "; export it again");
        };
    }

    private static InputStream member(ZipFile archive, String name, long bytes) throws IOException {
        ZipEntry entry = archive.getEntry(name);
        if (entry == null || entry.isDirectory() || entry.getSize() < bytes) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %s bytes of %s, where its matrix takes %d; copy or export it again",
                    entry == null ? "no" : Long.toString(entry.getSize()),
                    name,
                    bytes));
        }
        return archive.getInputStream(entry);
    }

    private static double[] samples(ScanBytes file, SampleBlock block, String points, Optional<String> valid)
            throws IOException {
        try (ZipFile archive = new ZipFile(file.path().toFile());
                InputStream in = member(archive, points, block.bytes())) {
            double[] samples = block.read(in);
            if (valid.isPresent()) {
                try (InputStream bits = member(archive, valid.get(), 0)) {
                    dropInvalid(samples, bits);
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

    /** One bit a sample, the lowest bit of a byte first; 0 where there is none. */
    private static void dropInvalid(double[] samples, InputStream in) throws IOException {
        byte[] bits = in.readNBytes((samples.length + 7) / 8);
        for (int i = 0; i < samples.length && i / 8 < bits.length; i++) {
            if ((bits[i / 8] >> i % 8 & 1) == 0) {
                samples[i] = Double.NaN;
            }
        }
    }
}
