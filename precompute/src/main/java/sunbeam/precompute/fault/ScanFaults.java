package sunbeam.precompute.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.HeightField;
import sunbeam.precompute.prepare.Tilt;

/**
 * Finds what is wrong with a scan: rows that were not measured, every second row shifted, heights that are clipped, rows that jump. In a time that grows
 * with the number of samples.
 */
public final class ScanFaults {
    private ScanFaults() {}

    /**
     * The faults of a scan, those that leave the least of it first.
     *
     * @param whole heights as they were measured, with their tilt, before anything is filled
     * @param crop the part that counts; all without it
     * @throws IllegalArgumentException when the crop does not suit the scan
     */
    public static List<ScanFault> in(HeightField whole, Optional<Crop> crop) {
        Measured scan = Measured.of(whole, crop);
        RowSteps steps = new RowSteps(scan);
        UnmeasuredRows unmeasured = new UnmeasuredRows(scan, steps);
        List<ScanFault> faults = new ArrayList<>(unmeasured.faults());
        faults.addAll(new AlternateRows(scan).faults());
        faults.addAll(
                new ClippedHeights(scan, unmeasured.all(), () -> Tilt.of(whole).rise()).faults());
        faults.addAll(new RowJumps(scan, steps, unmeasured.all()).faults());
        return faults;
    }
}
