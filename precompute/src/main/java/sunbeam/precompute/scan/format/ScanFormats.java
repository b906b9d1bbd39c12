package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.TextReader;

/** The formats that Sunbeam reads by itself. A new reader needs one line here. */
public final class ScanFormats {
    /** In the order in which they are asked; text last, as half of the others begin with some. */
    public static final List<ScanReader> ALL = List.of(
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
            new TextReader());

    private ScanFormats() {}

    /** The reader that knows a file's content; nothing for images and for what is not known. */
    public static Optional<ScanReader> find(ScanBytes file) throws IOException {
        for (ScanReader reader : ALL) {
            if (reader.recognises(file)) {
                return Optional.of(reader);
            }
        }
        return Optional.empty();
    }
}
