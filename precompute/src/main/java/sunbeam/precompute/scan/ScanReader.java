package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.List;

/**
 * One format of scans; the list of them is {@code scan.format.ScanFormats}.
 *
 * @param format what it is called, for people: "Gwyddion (.gwy)"
 * @param check whether a file is of this format
 * @param opener of its files
 */
public record ScanReader(String format, Check check, Opener opener) {
    /** Whether a file is of a format, by its content; cheap, and never an exception for what a file may hold. */
    @FunctionalInterface
    public interface Check {
        boolean recognizes(ScanBytes file) throws IOException;
    }

    /** Opens files of a format that were recognised. */
    @FunctionalInterface
    public interface Opener {
        /**
         * The channels of a file, in its order, from its header. Their samples can be read as long as the file is open.
         *
         * @throws ScanException when the file cannot be used
         */
        List<ScanChannel> channels(ScanBytes file) throws IOException;
    }

    /** A format whose files begin with one of these ASCII texts. */
    public static ScanReader of(String format, Opener opener, String... magics) {
        return new ScanReader(
                format,
                file -> {
                    for (String magic : magics) {
                        if (file.startsWith(magic)) {
                            return true;
                        }
                    }
                    return false;
                },
                opener);
    }

    /** As {@link Opener#channels}, with labels. */
    public ChannelList open(ScanBytes file) throws IOException {
        return new ChannelList(opener.channels(file));
    }
}
