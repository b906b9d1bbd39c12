package sunbeam.app.commands.inspect;

import java.util.List;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.units.Lengths;

/** What shows a period in a scan that shows none as it is: a bow, lines with offsets and steps hide one. */
final class PeriodRemedy {
    // Samples along a side; of a larger scan its middle is tried.
    private static final int LARGEST = 1024;
    // Of the heights' variance, in the wave.
    private static final double LEAST_SHARE = 0.1;
    // The interval's ends: a period that is known to a tenth.
    private static final double WIDEST = 1.1;
    private static final List<Levelling> LEVELLINGS = List.of(Levelling.QUADRATIC, Levelling.MEDIAN_ROWS);

    private PeriodRemedy() {}

    /** One line with the option that helps and what it shows; empty where none of those that are tried does. */
    static Optional<String> in(HeightMap scan) {
        HeightMap middle = part(
                scan,
                0.5 - reach(scan.columns()),
                0.5 + reach(scan.columns()),
                0.5 - reach(scan.rows()),
                0.5 + reach(scan.rows()));
        for (Levelling levelling : LEVELLINGS) {
            Optional<String> shown = period(middle.levelled(levelling));
            if (shown.isPresent()) {
                String option = OptionOrigin.INSTANCE.name(PatchSettings.LEVEL) + " " + levelling.label();
                return Optional.of(option + " shows one of " + shown.get());
            }
        }
        for (Half half : Half.values()) {
            Optional<String> shown = period(part(middle, half.left, half.right, half.bottom, half.top));
            if (shown.isPresent()) {
                return Optional.of("the scan's " + half.words + " half alone shows one of " + shown.get() + " ("
                        + OptionOrigin.INSTANCE.name(PatchSettings.CROP) + "): a step or another surface hides it");
            }
        }
        return Optional.empty();
    }

    /** Parts without the step that crosses the rest. */
    private enum Half {
        LEFT("left", 0, 0.5, 0, 1),
        RIGHT("right", 0.5, 1, 0, 1),
        LOWER("lower", 0, 1, 0, 0.5),
        UPPER("upper", 0, 1, 0.5, 1);

        private final String words;
        private final double left;
        private final double right;
        private final double bottom;
        private final double top;

        Half(String words, double left, double right, double bottom, double top) {
            this.words = words;
            this.left = left;
            this.right = right;
            this.bottom = bottom;
            this.top = top;
        }
    }

    private static double reach(int samples) {
        return Math.min(0.5, 0.5 * LARGEST / samples);
    }

    /** A part between shares of the width and height; the whole where too few samples lie there. */
    private static HeightMap part(HeightMap scan, double left, double right, double bottom, double top) {
        if (Math.min(scan.columns() * (right - left), scan.rows() * (top - bottom)) < 1) {
            return scan;
        }
        Crop crop = new Crop(left * scan.width(), right * scan.width(), bottom * scan.height(), top * scan.height());
        return scan.part(crop);
    }

    /**
     * Six ways are tried, each of which may find something by chance: only a wave counts that holds much of what is left of the
     * heights, and that can be followed through them.
     */
    private static Optional<String> period(HeightMap map) {
        Periodicity found = new PeriodFinder(map, false).all();
        double variance = Math.pow(HeightStatistics.of(map).rms(), 2);
        return found.peaks().stream()
                .limit(1)
                .filter(peak -> peak.rms() * peak.rms() >= LEAST_SHARE * variance)
                .flatMap(peak -> PeriodEstimator.estimate(map, peak).stream())
                .filter(told -> told.high() <= WIDEST * told.low())
                .map(told -> "about " + Lengths.rounded(told.period(), 3))
                .findFirst();
    }
}
