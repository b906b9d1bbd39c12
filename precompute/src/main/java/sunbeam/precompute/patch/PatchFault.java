package sunbeam.precompute.patch;

import java.util.Optional;
import sunbeam.precompute.prepare.Crop;

/**
 * What is wrong with a scan as it was measured, for people.
 *
 * @param words what
 * @param remedy the options that leave it out or take it away; empty where none does
 * @param unmeasured 0..1: share of the scan's rows that are no measurement
 * @param measured the largest part of the scan without them; empty where there are none
 */
public record PatchFault(String words, String remedy, double unmeasured, Optional<Crop> measured) {
    /** One line, without a full stop. */
    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
