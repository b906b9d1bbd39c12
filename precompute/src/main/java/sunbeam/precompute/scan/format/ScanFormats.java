package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.DecimalMark;
import sunbeam.precompute.scan.text.TextReader;

/** All file formats of scans. A new reader needs one line here. */
public final class ScanFormats {
    private static final ScanReader PICTURE =
            new ScanReader("image", PictureReader::recognizes, PictureReader::channels);

    /** Readers in the order of their checks; text and pictures come last. */
    private static final List<ScanReader> ALL = List.of(
            ScanReader.of("Gwyddion (.gwy)", GwyddionReader::channels, "GWYP", "GWYO"),
            ScanReader.of("Gwyddion Simple Field (.gsf)", SimpleFieldReader::channels, "Gwyddion Simple Field 1.0\n"),
            ScanReader.of(
                    "Bruker Nanoscope",
                    NanoscopeReader::channels,
                    "\\*File list",
                    "\\*EC File list",
                    "\\*Force file list"),
            ScanReader.of("Nanosurf (.nid)", NanosurfReader::channels, "[DataSet]"),
            new ScanReader("WSxM", WsxmReader::recognizes, WsxmReader::channels),
            ScanReader.of("Molecular Imaging (.mi)", AgilentReader::channels, "fileType      Image"),
            ScanReader.of("Digital Surf (.sur)", DigitalSurfReader::channels, "DIGITAL SURF", "DSCOMPRESSED"),
            new ScanReader("ISO 25178-71 (.sdf)", SurfaceDataReader::recognizes, SurfaceDataReader::channels),
            ScanReader.of("NumPy (.npy)", NumpyReader::channels, "\u0093NUMPY"),
            new ScanReader("ISO 25178-72 (.x3p)", X3pReader::recognizes, X3pReader::channels),
            new ScanReader("JPK", JpkReader::recognizes, JpkReader::channels),
            new ScanReader("Park Systems TIFF", ParkReader::recognizes, ParkReader::channels),
            new ScanReader("Igor binary wave (.ibw)", IgorWaveReader::recognizes, IgorWaveReader::channels));

    private ScanFormats() {}

    /**
     * Finds the reader of a file by its content; empty if none recognizes it.
     *
     * @param mark decimal mark of texts; the user's choice
     */
    public static Optional<ScanReader> find(ScanBytes file, Optional<DecimalMark> mark) throws IOException {
        for (ScanReader reader : ALL) {
            if (reader.check().recognizes(file)) {
                return Optional.of(reader);
            }
        }
        TextReader text = new TextReader(mark);
        if (text.recognizes(file)) {
            return Optional.of(new ScanReader("text", text::recognizes, text::channels));
        }
        return PICTURE.check().recognizes(file) ? Optional.of(PICTURE) : Optional.empty();
    }

    public static boolean isPicture(ScanReader reader) {
        return reader.equals(PICTURE);
    }
}
