package sunbeam.precompute.patch;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/** What no scan can be: smaller than a wavelength, larger than a hand, flatter than an atom or deeper than wide. */
final class ReliefCheck {
    /** The longer side must exceed this: no order of visible light leaves a smaller patch. */
    static final double SHORTEST_LONG_SIDE = 100e-9;

    static final double LONGEST_SIDE = 0.1;
    static final double LARGEST_RELIEF = 1e-3;
    /** A hundredth of an atom: no microscope sees less, no light scatters from it; a scale was mistaken. */
    static final double SMALLEST_RELIEF = 1e-12;
    /** Less than this scatters a few ten-thousandths of the light: a mirror, and most likely a mistaken unit. */
    static final double FLATTEST_RELIEF = 1e-9;
    /** Relief over the longer side; above, a scan is impossible and the scale is wrong. */
    static final double STEEPEST_RELIEF = 4;

    /** The most samples, 2048 x 2048, of a patch whose heights are all equal: work on them takes seconds. */
    static final long MOST_FLAT_SAMPLES = 1L << 22;

    private ReliefCheck() {}

    /** That a patch is a mirror to any eye; empty for all others. */
    static Optional<String> mirror(HeightMap map) {
        double relief = map.relief();
        if (relief == 0) {
            return Optional.of("all heights are equal: the patch is a flat mirror");
        }
        if (relief >= FLATTEST_RELIEF) {
            return Optional.empty();
        }
        // Phases of at most k w h / 2 about the middle, of the shortest wavelength along the normal.
        double phase = 2 * Math.PI * relief / SamplingCheck.SHORTEST_WAVELENGTH;
        return Optional.of(String.format(
                Locale.ROOT,
                "the relief is only %s, far below a wavelength: the patch is a mirror, which diffracts less than %.1g %% of the"
                        + " light; is the unit of the heights right?",
                Lengths.format(relief),
                100 * phase * phase));
    }

    /**
     * Refuses sizes that are absurd.
     *
     * @param about where the size was chosen; a file that says it itself is at fault otherwise
     */
    static void requireSize(double width, double height, Setting<?> about, Path file) {
        double longSide = Math.max(width, height);
        if (longSide < SHORTEST_LONG_SIDE || longSide > LONGEST_SIDE) {
            throw new SettingException(
                    about,
                    String.format(
                            Locale.ROOT,
                            "is absurd: %s would be %s x %s; a patch's longer side is %s to %s (is the unit right?)",
                            file,
                            Lengths.format(width),
                            Lengths.format(height),
                            Lengths.format(SHORTEST_LONG_SIDE),
                            Lengths.format(LONGEST_SIDE)));
        }
    }

    /**
     * Refuses a large file without any relief: not one of an instrument, whose noise would show, but an empty one, which
     * may take no place on a disk and yet minutes to work on.
     */
    static void requireContent(HeightMap map, Path file) {
        long samples = (long) map.columns() * map.rows();
        if (map.relief() == 0 && samples > MOST_FLAT_SAMPLES) {
            throw new PatchException(String.format(
                    Locale.ROOT,
                    "%s: all of its %d x %d samples are equal: it is empty; export the scan again"
                            + " (of a flat mirror 2048 x 2048 samples are enough)",
                    file,
                    map.columns(),
                    map.rows()));
        }
    }

    /** What is absurd about the relief of a map, continuing "makes a relief of ..."; flat maps are not. */
    static Optional<String> absurdity(HeightMap map) {
        double relief = map.relief();
        double longSide = Math.max(map.width(), map.height());
        if (relief > 0 && relief < SMALLEST_RELIEF) {
            return Optional.of(Lengths.format(relief) + ", less than a hundredth of an atom");
        }
        if (relief > LARGEST_RELIEF || relief > STEEPEST_RELIEF * longSide) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "%s on a patch of %s, which is absurd; check both units",
                    Lengths.format(relief),
                    Lengths.format(longSide)));
        }
        return Optional.empty();
    }

    /**
     * Refuses a scan's relief where it is absurd.
     *
     * @param unitChosen whether the user said the unit
     */
    static void requireOfScan(HeightMap map, boolean unitChosen, Path file) {
        Optional<String> absurdity = absurdity(map);
        if (absurdity.isEmpty()) {
            return;
        }
        if (unitChosen) {
            String remedy = map.relief() < SMALLEST_RELIEF ? "; give a larger unit" : "";
            throw new SettingException(PatchSettings.HEIGHT_UNIT, "makes a relief of " + absurdity.get() + remedy);
        }
        throw new PatchException(String.format(
                Locale.ROOT, "%s has a relief of %s; its scale is wrong, export it again", file, absurdity.get()));
    }
}
