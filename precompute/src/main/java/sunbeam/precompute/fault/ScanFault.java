package sunbeam.precompute.fault;

import java.util.Optional;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;

/**
 * Something that is wrong with a scan.
 *
 * @param words what, for people, without a full stop; rows are counted from 1 at the top of the whole scan
 * @param part the largest part of the whole scan that is free of it; empty where none is, or none is needed
 * @param levelling what takes it away; empty where nothing does
 * @param unmeasured 0..1: share of the rows that count which are no measurement
 */
public record ScanFault(String words, Optional<Crop> part, Optional<Levelling> levelling, double unmeasured) {

    /** One that a part of the scan is free of. */
    static ScanFault ofRows(String words, Optional<Crop> part, double unmeasured) {
        return new ScanFault(words, part, Optional.empty(), unmeasured);
    }

    /** One of all rows, which are no measurement of one surface, that nothing takes away. */
    static ScanFault ofAllRows(String words) {
        return new ScanFault(words, Optional.empty(), Optional.empty(), 1);
    }

    /** One that levelling takes away. */
    static ScanFault levelledBy(Levelling levelling, String words) {
        return new ScanFault(words, Optional.empty(), Optional.of(levelling), 0);
    }

    /** One that nothing takes away. */
    static ScanFault lasting(String words) {
        return new ScanFault(words, Optional.empty(), Optional.empty(), 0);
    }
}
