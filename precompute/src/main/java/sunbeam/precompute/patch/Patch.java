package sunbeam.precompute.patch;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.ScanFault;

/**
 * Surface that is ready for analysis and rendering: complete heights in meters.
 *
 * @param scan the heights before their edges were blended
 * @param known the scan with NaN where samples were missing and are filled
 * @param channels one line per channel of the file: number, name, samples and unit; empty for built-in patches
 * @param faults faults of the measurement, also among the warnings (the gravest first)
 */
public record Patch(
        String name,
        HeightMap heights,
        HeightMap scan,
        HeightMap known,
        String source,
        List<String> channels,
        List<String> notes,
        List<String> warnings,
        List<ScanFault> faults,
        Repetition repetition) {

    /** Makes a patch without filled samples. */
    public Patch(
            String name,
            HeightMap heights,
            HeightMap scan,
            String source,
            List<String> channels,
            List<String> notes,
            List<String> warnings,
            List<ScanFault> faults,
            Repetition repetition) {
        this(name, heights, scan, scan, source, channels, notes, warnings, faults, repetition);
    }

    // Difference between neighbors that counts as none, relative to the relief.
    private static final double SAME = 1e-4;

    /** Surface outside of the heights. */
    public enum Repetition {
        PERIODIC,
        /** Repeated without knowledge whether the heights are a period. */
        ASSUMED,
        /** A piece without period, which limits the coherence length. */
        NONE
    }

    /** Returns the first warning and the number of others. */
    public Optional<String> warning() {
        String others = warnings.size() > 1 ? " (inspect has " + (warnings.size() - 1) + " more)" : "";
        return warnings.stream().findFirst().map(first -> first + others);
    }

    /** Returns the patch under another name, for a reason among its notes. */
    public Patch named(String other, String why) {
        List<String> allNotes = new ArrayList<>(notes);
        allNotes.add(why);
        return new Patch(other, heights, scan, known, source, channels, allNotes, warnings, faults, repetition);
    }

    /** Returns the measured part of the scan, to which statistics of the heights refer, with NaN where samples are filled. */
    public HeightMap measured() {
        return ScanFault.measured(known, faults);
    }

    /** Returns the finite ones of the measured heights, meters. */
    public double[] measuredHeights() {
        return Arrays.stream(measured().heights()).filter(Double::isFinite).toArray();
    }

    public ModelError slopes() {
        return ModelError.of(measured(), ScanFault.measured(scan, faults), repetition);
    }

    /** Returns how many samples are filled, if any are. */
    public Optional<String> gaps() {
        return gaps(known);
    }

    static Optional<String> gaps(HeightMap known) {
        long missing = Arrays.stream(known.heights())
                .filter(height -> !Double.isFinite(height))
                .count();
        return missing == 0
                ? Optional.empty()
                : Optional.of(missing + " of " + known.heights().length
                        + " samples are missing and were filled from their neighbors");
    }

    /** Returns the shorter side along which heights change, meters; infinite for a flat patch. */
    public double shorterSide() {
        double alongX = changes(1, 0) ? heights.width() : Double.POSITIVE_INFINITY;
        double alongY = changes(0, 1) ? heights.height() : Double.POSITIVE_INFINITY;
        return Math.min(alongX, alongY);
    }

    private boolean changes(int columns, int rows) {
        double least = SAME * scan.relief();
        for (int row = 0; row + rows < scan.rows(); row++) {
            for (int column = 0; column + columns < scan.columns(); column++) {
                if (Math.abs(scan.at(column + columns, row + rows) - scan.at(column, row)) > least) {
                    return true;
                }
            }
        }
        return false;
    }

    /** True if the relief is so far below a wavelength that the patch looks like a mirror. */
    public boolean isMirror() {
        return scan.relief() < Plausibility.FLATTEST_RELIEF;
    }
}
