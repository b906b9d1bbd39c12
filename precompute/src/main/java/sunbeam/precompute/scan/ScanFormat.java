package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** File format of scans, found by content, with a name for messages. */
public record ScanFormat(String name, Reading<Boolean> check, Reading<List<ScanChannel>> opener) {
    private static final ScanFormat PICTURE =
            new ScanFormat("image", file -> PictureReader.kind(file).isPresent(), PictureReader::channels);

    /** All but text and pictures, in the order of their checks; {@link #find} then tries text, and last pictures. */
    private static final List<ScanFormat> ALL = List.of(
            ScanFormat.of("Gwyddion (.gwy)", GwyddionReader::channels, "GWYP", "GWYO"),
            ScanFormat.of("Gwyddion Simple Field (.gsf)", GwyddionReader::simpleField, "Gwyddion Simple Field 1.0\n"),
            ScanFormat.of(
                    "Bruker Nanoscope",
                    NanoscopeReader::channels,
                    "\\*File list",
                    "\\*EC File list",
                    "\\*Force file list"),
            ScanFormat.of("Nanosurf (.nid)", InstrumentReaders::nanosurf, "[DataSet]"),
            new ScanFormat("WSxM", InstrumentReaders::isWsxm, InstrumentReaders::wsxm),
            ScanFormat.of("Molecular Imaging (.mi)", InstrumentReaders::agilent, "fileType      Image"),
            ScanFormat.of("Digital Surf (.sur)", BinaryHeaderReaders::digitalSurf, "DIGITAL SURF", "DSCOMPRESSED"),
            new ScanFormat("ISO 25178-71 (.sdf)", SurfaceDataReaders::isSdf, SurfaceDataReaders::sdf),
            ScanFormat.of("NumPy (.npy)", BinaryHeaderReaders::numpy, "\u0093NUMPY"),
            new ScanFormat("ISO 25178-72 (.x3p)", SurfaceDataReaders::isX3p, SurfaceDataReaders::x3p),
            new ScanFormat("JPK", InstrumentReaders::isJpk, InstrumentReaders::jpk),
            new ScanFormat("Park Systems TIFF", InstrumentReaders::isPark, InstrumentReaders::park),
            new ScanFormat("Igor binary wave (.ibw)", BinaryHeaderReaders::isIgorWave, BinaryHeaderReaders::igorWave),
            ScanFormat.of("Wyko (.opd)", OpticalReaders::wyko, "\1\0Directory"),
            ScanFormat.of("Wyko ASCII (.asc)", OpticalReaders::wykoText, "Wyko ASCII Data File Format"),
            ScanFormat.of(
                    "Zygo MetroPro (.dat)",
                    OpticalReaders::metroPro,
                    "\u0088\u001b\u0003o",
                    "\u0088\u001b\u0003p",
                    "\u0088\u001b\u0003q"),
            ScanFormat.of("Alicona (.al3d)", OpticalReaders::alicona, "AliconaImaging\0\r\n"),
            ScanFormat.of("Keyence (.vk4)", OpticalReaders::keyence, "VK3_", "VK4_", "VK6", "VK7"),
            new ScanFormat("BCR-STM (.bcr, .bcrf)", OpticalReaders::isBcr, OpticalReaders::bcr),
            new ScanFormat("Sensofar (.plu)", OpticalReaders::isSensofar, OpticalReaders::sensofar));

    /**
     * Either the check whether a file has the format, which is fast and throws no exception for any content; or the reader of its channels, which
     * reads headers and throws ScanException if the file cannot be used. The channels' samples can be read while the file is open.
     */
    @FunctionalInterface
    public interface Reading<T> {
        T read(ScanBytes file) throws IOException;
    }

    private static ScanFormat of(String name, Reading<List<ScanChannel>> opener, String... magics) {
        return new ScanFormat(name, file -> file.startsWith(magics), opener);
    }

    public ChannelList open(ScanBytes file) throws IOException {
        return new ChannelList(opener.read(file));
    }

    /** Finds a reader by content; the mark is the user's choice for texts. */
    public static Optional<ScanFormat> find(ScanBytes file, Optional<TextReader.DecimalMark> mark) throws IOException {
        for (ScanFormat reader : ALL) {
            if (reader.check.read(file)) {
                return Optional.of(reader);
            }
        }
        Optional<TextFile> text = TextFile.of(file, mark);
        if (text.isPresent()) {
            return Optional.of(new ScanFormat("text", same -> true, same -> TextReader.channels(text.get())));
        }
        return PICTURE.check.read(file) ? Optional.of(PICTURE) : Optional.empty();
    }

    public boolean isPicture() {
        return equals(PICTURE);
    }
}
