package sunbeam.precompute.prepare;

import java.util.Optional;

/**
 * Fault of a measured scan.
 *
 * @param words description without a full stop; rows are counted from 1 at the top of the whole scan
 * @param part largest part of the scan without the fault; empty if no part is, or if a leveling removes the fault
 * @param unmeasured share, 0..1, of rows without a measurement
 * @param remedy text that names the option that removes the fault; empty if unknown
 */
public record ScanFault(
        String words, Optional<Crop> part, Optional<Leveling> leveling, double unmeasured, String remedy) {
    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
