package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.DecimalMark;
import sunbeam.precompute.scan.text.TextReader;

/** The formats that Sunbeam reads by itself. A new reader needs one line here. */
public final class ScanFormats {
    private ScanFormats() {}

    /**
     * All readers, in the order in which they are asked; text after those that begin with some.
     *
     * @param mark of decimals in a text, where the user says it
     */
    public static List<ScanReader> all(Optional<DecimalMark> mark) {
        return List.of(
                new GwyddionReader(),
                new SimpleFieldReader(),
                new NanoscopeReader(),
                new NanosurfReader(),
                new WsxmReader(),
                new AgilentReader(),
                new DigitalSurfReader(),
                new SurfaceDataReader(),
                new NumpyReader(),
                new X3pReader(),
                new JpkReader(),
                new ParkReader(),
                new IgorWaveReader(),
                new TextReader(mark),
                new PictureReader());
    }

    /** The reader that knows a file's content; nothing for what is not known. */
    public static Optional<ScanReader> find(ScanBytes file, Optional<DecimalMark> mark) throws IOException {
        for (ScanReader reader : all(mark)) {
            if (reader.recognises(file)) {
                return Optional.of(reader);
            }
        }
        return Optional.empty();
    }
}
