package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.List;

/** Reads one format of scans. A reader is registered in {@code scan.format.ScanFormats}. */
public interface ScanReader {
    /** What the format is called, for people: "Gwyddion (.gwy)". */
    String format();

    /** Whether a file is of this format, by its content; cheap, and never an exception for what a file may hold. */
    boolean recognises(ScanBytes file) throws IOException;

    /**
     * The channels of a file that was recognised, in its order, from its header. Their samples can be read as long as the
     * file is open.
     *
     * @throws ScanException when the file cannot be used
     */
    List<ScanChannel> channels(ScanBytes file) throws IOException;

    /** Whether files of this format are pictures, which know no scale. */
    default boolean isPicture() {
        return false;
    }
}
