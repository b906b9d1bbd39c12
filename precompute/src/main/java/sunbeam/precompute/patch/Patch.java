package sunbeam.precompute.patch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.optics.HeightMap;

/**
 * A surface, ready for everything that follows.
 *
 * @param name short name for titles and files: the built-in name, or the file's name without folder and extension
 * @param heights as light sees them: prepared heights in meters; no sample is missing
 * @param scan the same before its edges were treated: what was measured
 * @param source where the heights come from and how they were read and prepared, for people
 * @param channels a line for each channel of a scan, with its number, name and unit; empty for all else
 * @param notes what was chosen for the user, one line each
 * @param warnings what the user should know, one line each, the gravest first; empty when all is well
 * @param faults what is wrong with the scan as it was measured; the warnings have it, too
 * @param repetition whether the surface goes on beyond the heights as they do
 */
public record Patch(
        String name,
        HeightMap heights,
        HeightMap scan,
        String source,
        List<String> channels,
        List<String> notes,
        List<String> warnings,
        List<ScanFault> faults,
        Repetition repetition) {

    private static final double SAME = 1e-4;

    /** What is known of a surface beyond its heights. */
    public enum Repetition {
        /** The heights are a period. */
        PERIODIC,
        /** Nobody says, and the heights are repeated as they are. */
        ASSUMED,
        /** The heights are a piece: light must not look farther than they reach. */
        NONE
    }

    public Patch {
        channels = List.copyOf(channels);
        notes = List.copyOf(notes);
        warnings = List.copyOf(warnings);
        faults = List.copyOf(faults);
    }

    /** A period of a surface that comes from no scan. */
    public Patch(String name, HeightMap heights, String source, List<String> warnings) {
        this(name, heights, heights, source, List.of(), List.of(), warnings, List.of(), Repetition.PERIODIC);
    }

    /** The first of the warnings, for whoever tells one line a run; empty when all is well. */
    public Optional<String> warning() {
        String others = warnings.size() > 1 ? " (inspect has " + (warnings.size() - 1) + " more)" : "";
        return warnings.stream().findFirst().map(first -> first + others);
    }

    /**
     * The same under another name.
     *
     * @param why for people: a note beside the others
     */
    public Patch named(String other, String why) {
        List<String> told = new ArrayList<>(notes);
        told.add(why);
        return new Patch(other, heights, scan, source, channels, told, warnings, faults, repetition);
    }

    /** The shorter side of what was measured, of axes along which it changes at all; meters, infinite where it is flat. */
    public double shorterSide() {
        double alongX = changes(1, 0) ? scan.width() : Double.POSITIVE_INFINITY;
        double alongY = changes(0, 1) ? scan.height() : Double.POSITIVE_INFINITY;
        return Math.min(alongX, alongY);
    }

    /** Whether neighbors along an axis differ by more than a ten-thousandth of the relief anywhere. */
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

    /** Whether the relief is so far below a wavelength that the patch looks like a mirror; its warnings say so, too. */
    public boolean isMirror() {
        return Plausibility.mirror(scan).isPresent();
    }

    /** SHA-256 of the height map, for cache keys; see {@link HeightMap#digest}. */
    public String digest() {
        return heights.digest();
    }
}
