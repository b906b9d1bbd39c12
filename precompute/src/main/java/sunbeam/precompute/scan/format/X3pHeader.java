package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.Optional;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * What main.xml of an .x3p says.
 *
 * @param pitchX metres
 * @param pitchY metres
 * @param stepZ metres of one unit of the samples
 * @param offsetZ metres
 * @param pointData name of the member with the samples; empty when they stand in main.xml itself
 * @param validPoints name of the member with a bit for each valid sample; empty without one
 */
record X3pHeader(
        int columns,
        int rows,
        double pitchX,
        double pitchY,
        double stepZ,
        double offsetZ,
        SampleType type,
        String pointData,
        String validPoints) {
    static final String NAME = "main.xml";
    /** Characters of main.xml; it has a few thousand without samples, with them 40 for each. */
    private static final int MOST_TEXT = 1 << 12;

    /** Bytes of main.xml before its samples. */
    private static final long LARGEST_HEADER = 1 << 20;

    private static final int BYTES_PER_DATUM = 200;
    private static final int MOST_ELEMENTS = 1000;
    private static final int DEEPEST = 32;

    /** Reads all but samples; stops after as many elements as any such file has. */
    static X3pHeader read(InputStream in) throws IOException {
        Header values = new Header();
        try {
            XMLStreamReader xml = open(new BoundedStream(in, LARGEST_HEADER));
            Deque<String> path = new ArrayDeque<>();
            StringBuilder text = new StringBuilder();
            int elements = 0;
            while (xml.hasNext() && elements < MOST_ELEMENTS) {
                int event = xml.next();
                if (event == XMLStreamConstants.START_ELEMENT) {
                    elements++;
                    path.addLast(xml.getLocalName());
                    text.setLength(0);
                    if (path.size() > DEEPEST) {
                        throw new ScanException("nests its main.xml too deep; export it again");
                    }
                    if (xml.getLocalName().equals("DataList")) {
                        break;
                    }
                } else if (event == XMLStreamConstants.CHARACTERS && text.length() < MOST_TEXT) {
                    text.append(xml.getText());
                } else if (event == XMLStreamConstants.END_ELEMENT) {
                    String parent = path.size() < 2
                            ? ""
                            : path.stream().skip(path.size() - 2).findFirst().orElse("");
                    values.put(parent + "/" + path.removeLast(), text.toString());
                    text.setLength(0);
                }
            }
        } catch (XMLStreamException broken) {
            throw new ScanException("has a main.xml that is no valid XML; copy or export it again", broken);
        }
        return of(values);
    }

    private static X3pHeader of(Header values) {
        requireIncremental(values, "CX");
        requireIncremental(values, "CY");
        if (values.number("MatrixDimension/SizeZ", 1) != 1) {
            throw new ScanException("holds several layers; export one of them");
        }
        int columns = values.count("MatrixDimension/SizeX");
        int rows = values.count("MatrixDimension/SizeY");
        ScanLimits.requireSize(columns, rows);
        return new X3pHeader(
                columns,
                rows,
                values.number("CX/Increment"),
                values.number("CY/Increment"),
                values.number("CZ/Increment", 1),
                values.number("CZ/Offset", 0),
                type(values.text("CZ/DataType", "D")),
                values.text("DataLink/PointDataLink", ""),
                values.text("DataLink/ValidPointsLink", ""));
    }

    private static void requireIncremental(Header values, String axis) {
        if (!values.text(axis + "/AxisType", "I").equals("I")) {
            throw new ScanException("holds points on no grid; interpolate them and export a matrix");
        }
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

    /** The samples in main.xml: an element Datum each, of which the last of its numbers is z; empty where one is missing. */
    static double[] dataList(InputStream in, long count) throws IOException {
        double[] samples = new double[Math.toIntExact(count)];
        int read = 0;
        try {
            XMLStreamReader xml = open(new BoundedStream(in, LARGEST_HEADER + BYTES_PER_DATUM * count));
            StringBuilder text = new StringBuilder();
            while (xml.hasNext() && read < count) {
                int event = xml.next();
                if (event == XMLStreamConstants.START_ELEMENT) {
                    text.setLength(0);
                } else if (event == XMLStreamConstants.CHARACTERS && text.length() < MOST_TEXT) {
                    text.append(xml.getText());
                } else if (event == XMLStreamConstants.END_ELEMENT
                        && xml.getLocalName().equals("Datum")) {
                    String datum = text.substring(1 + Math.max(text.lastIndexOf(";"), text.lastIndexOf(" ")));
                    samples[read++] = Header.number(Optional.of(datum)).orElse(Double.NaN);
                }
            }
        } catch (XMLStreamException broken) {
            throw new ScanException("has a main.xml that is no valid XML; copy or export it again", broken);
        }
        if (read < count) {
            throw new ScanException(String.format(
                    Locale.ROOT, "has %d samples where %d are announced; copy or export it again", read, count));
        }
        return samples;
    }

    /** A reader that follows no reference to anything outside. */
    private static XMLStreamReader open(InputStream in) throws XMLStreamException {
        XMLInputFactory factory = XMLInputFactory.newInstance();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        return factory.createXMLStreamReader(in);
    }
}
