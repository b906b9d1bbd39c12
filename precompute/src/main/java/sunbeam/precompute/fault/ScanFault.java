package sunbeam.precompute.fault;

import java.util.Optional;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;

/**
 * Something that is wrong with a scan as it was measured.
 *
 * @param words what, for people, without a full stop; rows are counted from 1 at the top of the whole scan
 * @param part the largest part of the scan that is free of it; empty where none is, or none is needed
 * @param levelling what takes it away; empty where nothing does
 * @param unmeasured 0..1: share of the rows that count which are no measurement
 * @param remedy the options that leave it out or take it away; empty where nobody says
 */
public record ScanFault(
        String words, Optional<Crop> part, Optional<Levelling> levelling, double unmeasured, String remedy) {

    /** One line, without a full stop. */
    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
