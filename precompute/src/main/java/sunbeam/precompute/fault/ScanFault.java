package sunbeam.precompute.fault;

import java.util.Optional;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Leveling;

/**
 * Fault of a measured scan.
 *
 * @param words description without a full stop; rows are counted from 1 at the top of the whole scan
 * @param part largest part of the scan without the fault; empty if there is none, or none is needed
 * @param leveling leveling that removes the fault; empty if none does
 * @param unmeasured share, 0..1, of rows without a measurement
 * @param remedy options that crop or remove the fault; empty if unknown
 */
public record ScanFault(
        String words, Optional<Crop> part, Optional<Leveling> leveling, double unmeasured, String remedy) {

    /** Returns one line without a full stop. */
    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
