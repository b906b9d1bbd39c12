package sunbeam.precompute.prepare;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;

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
    // Share of unmeasured rows; a crop may lose half of the scan.
    private static final double FEW_UNMEASURED = 0.02;

    /** Returns the part of a scan without unmeasured rows, of which patterns and slopes are not the surface's; all of it if they are few. */
    public static HeightMap measured(HeightMap scan, List<ScanFault> faults) {
        return faults.stream()
                .filter(fault -> fault.unmeasured() > FEW_UNMEASURED)
                .flatMap(fault -> fault.part().stream())
                .findFirst()
                .map(part -> part.apply(scan))
                .orElse(scan);
    }

    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
