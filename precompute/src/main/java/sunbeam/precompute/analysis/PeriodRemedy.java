package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.units.Lengths;

/**
 * What shows a period in a scan that shows none as it is: a bow, lines with offsets and steps hide one.
 *
 * @param levelling that shows it; empty where a part does
 * @param part of the scan that shows it; empty where levelling does
 * @param half of the scan in which the part lies: "left"; empty where there is none
 * @param told the period
 * @param direction across its lines, radians counter-clockwise from +x, 0 to below pi
 */
public record PeriodRemedy(
        Optional<Levelling> levelling, Optional<Crop> part, String half, PeriodEstimate told, double direction) {
    // Samples along a side; of a larger scan its middle is tried.
    private static final int LARGEST = 1024;
    // Of the heights' variance, in the wave.
    private static final double LEAST_SHARE = 0.1;
    // The interval's ends: a period that is known to a tenth.
    private static final double WIDEST = 1.1;
    private static final List<Levelling> LEVELLINGS = List.of(Levelling.QUADRATIC, Levelling.MEDIAN_ROWS);

    /** Of a scan without periods; empty where nothing of what is tried shows one. */
    public static Optional<PeriodRemedy> in(HeightMap scan) {
        Crop middle = middle(scan);
        HeightMap tried = part(scan, middle);
        for (Levelling levelling : LEVELLINGS) {
            Optional<PeriodRemedy> shown =
                    period(tried.levelled(levelling), Optional.of(levelling), Optional.empty(), "");
            if (shown.isPresent()) {
                return shown;
            }
        }
        for (Half half : Half.values()) {
            Crop crop = half.of(middle);
            Optional<PeriodRemedy> shown = period(part(scan, crop), Optional.empty(), Optional.of(crop), half.word);
            if (shown.isPresent()) {
                return shown;
            }
        }
        return Optional.empty();
    }

    /**
     * One line with the option that helps and what it shows.
     *
     * @param patch whose scan it is
     * @param origin where options would be chosen
     */
    public String describe(Patch patch, Origin origin) {
        String shown = " shows one of about " + Lengths.rounded(told.period(), 3);
        return levelling
                .map(by -> origin.name(PatchSettings.LEVEL) + " " + by.label() + shown)
                .orElseGet(() -> "the scan's " + half + " half alone" + shown + " (" + origin.name(PatchSettings.CROP)
                        + " " + patch.inFile(part.orElseThrow()) + "): a step or another surface hides it");
    }

    /** Parts without the step that crosses the rest. */
    private enum Half {
        LEFT("left", 0, 0.5, 0, 1),
        RIGHT("right", 0.5, 1, 0, 1),
        LOWER("lower", 0, 1, 0, 0.5),
        UPPER("upper", 0, 1, 0.5, 1);

        private final String word;
        private final double left;
        private final double right;
        private final double bottom;
        private final double top;

        Half(String word, double left, double right, double bottom, double top) {
            this.word = word;
            this.left = left;
            this.right = right;
            this.bottom = bottom;
            this.top = top;
        }

        Crop of(Crop whole) {
            double width = whole.right() - whole.left();
            double height = whole.top() - whole.bottom();
            return new Crop(
                    whole.left() + left * width,
                    whole.left() + right * width,
                    whole.bottom() + bottom * height,
                    whole.bottom() + top * height);
        }
    }

    /** What is tried of a scan: all, or the middle of a large one. */
    static Crop middle(HeightMap scan) {
        double x = Math.min(0.5, 0.5 * LARGEST / scan.columns());
        double y = Math.min(0.5, 0.5 * LARGEST / scan.rows());
        return new Crop(
                (0.5 - x) * scan.width(),
                (0.5 + x) * scan.width(),
                (0.5 - y) * scan.height(),
                (0.5 + y) * scan.height());
    }

    /** The whole where too few samples lie there. */
    static HeightMap part(HeightMap scan, Crop crop) {
        double columns = (crop.right() - crop.left()) / scan.pitchX();
        double rows = (crop.top() - crop.bottom()) / scan.pitchY();
        return Math.min(columns, rows) < 1 ? scan : scan.part(crop);
    }

    /**
     * Six ways are tried, each of which may find something by chance: only a wave counts that holds much of what is left of the
     * heights, and that can be followed through them.
     */
    private static Optional<PeriodRemedy> period(
            HeightMap map, Optional<Levelling> levelling, Optional<Crop> part, String half) {
        Periodicity found = new PeriodFinder(map, false).all();
        double variance = Math.pow(HeightStatistics.of(map).rms(), 2);
        return found.peaks().stream()
                .limit(1)
                .filter(peak -> peak.rms() * peak.rms() >= LEAST_SHARE * variance)
                .flatMap(peak -> PeriodEstimator.estimate(map, peak).stream()
                        .filter(told -> told.doubt() == PeriodEstimate.Doubt.NONE && told.high() <= WIDEST * told.low())
                        .map(told -> new PeriodRemedy(levelling, part, half, told, peak.direction())))
                .findFirst();
    }
}
