package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.List;

/**
 * Reader of one file format; {@code scan.format.ScanFormats} lists all.
 *
 * @param format name for messages, such as "Gwyddion (.gwy)"
 */
public record ScanReader(String format, Check check, Opener opener) {
    /** Fast test whether a file has a format; it throws no exception for any content. */
    @FunctionalInterface
    public interface Check {
        boolean recognizes(ScanBytes file) throws IOException;
    }

    /** Reads files of a format that the check has accepted. */
    @FunctionalInterface
    public interface Opener {
        /**
         * Reads the channels from the header, in the file's order. Their samples can be read while the file is open.
         *
         * @throws ScanException if the file cannot be used
         */
        List<ScanChannel> channels(ScanBytes file) throws IOException;
    }

    /** Creates a reader of files that begin with one of these ASCII texts. */
    public static ScanReader of(String format, Opener opener, String... magics) {
        return new ScanReader(format, file -> file.startsWith(magics), opener);
    }

    public ChannelList open(ScanBytes file) throws IOException {
        return new ChannelList(opener.channels(file));
    }
}
