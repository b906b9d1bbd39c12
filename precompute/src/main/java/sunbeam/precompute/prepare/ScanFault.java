package sunbeam.precompute.prepare;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;

/**
 * Fault of a measured scan.
 *
 * @param words description without a full stop; rows are counted from 1 at the top of the whole scan
 * @param part largest part of the scan without the fault; empty if no part is, or if a leveling removes the fault
 * @param unmeasured rows of the examined part without a measurement, ascending, from 0 at the top
 * @param remedy text that names the option that removes the fault; empty if unknown
 */
public record ScanFault(
        String words, Optional<Crop> part, Optional<Leveling> leveling, List<Integer> unmeasured, String remedy) {
    // Share of unmeasured rows; a crop may lose half of the scan.
    private static final double FEW_UNMEASURED = 0.02;

    /** Returns the part of a scan without unmeasured rows, of which patterns and slopes are not the surface's; all of it if they are few. */
    public static HeightMap measured(HeightMap scan, List<ScanFault> faults) {
        return faults.stream()
                .filter(fault -> fault.unmeasured().size() > FEW_UNMEASURED * scan.rows())
                .flatMap(fault -> fault.part().stream())
                .findFirst()
                .map(part -> part.apply(scan))
                .orElse(scan);
    }

    /**
     * Returns the scan from its first measured row to its last one, with straight lines across rows without a measurement; the largest measured
     * part if these rows are more than the measured ones that it leaves out.
     */
    public static HeightMap bridged(HeightMap scan, List<ScanFault> faults) {
        BitSet gaps = new BitSet();
        faults.forEach(fault -> fault.unmeasured().forEach(gaps::set));
        int first = gaps.nextClearBit(0);
        int end = gaps.previousClearBit(scan.rows() - 1) + 1;
        HeightMap largest = measured(scan, faults);
        int across = gaps.get(first, Math.max(first, end)).cardinality();
        if (largest.rows() < scan.rows() && across > scan.rows() - gaps.cardinality() - largest.rows()) {
            return largest;
        }
        HeightMap whole =
                new Crop.Samples(0, scan.columns(), first, end).area(scan).apply(scan);
        double[] heights = whole.heights().clone();
        for (int row = gaps.nextSetBit(first); row >= 0 && row < end; row = gaps.nextSetBit(row + 1)) {
            int before = gaps.previousClearBit(row);
            int after = gaps.nextClearBit(row);
            double part = (double) (row - before) / (after - before);
            for (int column = 0; column < scan.columns(); column++) {
                heights[(row - first) * scan.columns() + column] =
                        (1 - part) * scan.at(column, before) + part * scan.at(column, after);
            }
        }
        return whole.with(heights);
    }

    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
