package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import sunbeam.precompute.analysis.IntervalWords;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.evaluation.PeriodAnswer;
import sunbeam.precompute.units.Lengths;

/** The period and how well it is known: what is printed first. */
final class PeriodReport {
    private static final double NANOMETRES = 1e9;
    // Half an interval over the period.
    private static final double EVEN = 0.03;
    // A drift or disagreement below this share of the period is not worth a line.
    private static final double EXACT = 1e-4;
    private static final double WORTH_SAYING = 2e-3;
    // Of a frequency and the part of another that it is, for few periods.
    private static final double ALIKE = 0.05;
    private static final int LARGEST_DIVISOR = 5;

    private PeriodReport() {}

    /** @param target with all that the heights show */
    static List<String> lines(PeriodAnswer answer, GratingTarget target) {
        List<String> lines = new ArrayList<>(lines(answer));
        Periodicity periods = target.heights();
        target.direction()
                .ifPresent(direction ->
                        lines.add("direction            " + direction.describe(0) + ", of the heights' wave"));
        target.alias().ifPresent(alias -> lines.add("coarse samples       " + alias));
        periods.peaks().stream()
                .flatMap(peak -> unlike(peak, answer.heights(), periods).stream())
                .findFirst()
                .ifPresent(lines::add);
        periods.peaks().stream()
                .skip(1)
                .filter(peak -> peak.isAcross(periods.peaks().get(0)))
                .forEach(peak -> lines.add(across(peak, periods.peaks().get(0))));
        return lines;
    }

    /** Another wave of a lattice. */
    private static String across(SpectrumPeak peak, SpectrumPeak first) {
        double degrees = Math.toDegrees(peak.direction());
        return String.format(
                Locale.ROOT,
                "a lattice            another wave, of about %s, runs in direction %.1f degrees, %.2g times as high: --azimuth %.1f measures it",
                Lengths.rounded(peak.period(), 2),
                degrees,
                peak.rms() / first.rms(),
                degrees > 90 ? degrees - 180 : degrees);
    }

    /** Where every second or so line differs, and the surface itself repeats only after several. */
    private static Optional<String> unlike(SpectrumPeak below, PeriodEstimate told, Periodicity periods) {
        long divisor = Math.round(below.period() / told.period());
        // Of lines at uneven distances chance makes such waves.
        boolean even = told.halfWidth() < EVEN * told.period();
        boolean whole = even && divisor >= 2 && divisor <= LARGEST_DIVISOR;
        Optional<SpectrumPeak> first = periods.peaks().stream()
                .filter(peak -> whole && isMultiple(peak, below, divisor))
                .findFirst();
        return first.map(line -> String.format(
                Locale.ROOT,
                "lines differ         each from its neighbours, not from the %s next: the surface repeats after about %.0f nm, a wave %.2g times as high",
                divisor == 2 ? "second" : divisor == 3 ? "third" : divisor + "th",
                divisor * told.period() * NANOMETRES,
                below.rms() / line.rms()));
    }

    private static boolean isMultiple(SpectrumPeak peak, SpectrumPeak below, long divisor) {
        return Math.hypot(
                        peak.frequencyX() - divisor * below.frequencyX(),
                        peak.frequencyY() - divisor * below.frequencyY())
                <= ALIKE * peak.frequency();
    }

    static List<String> lines(PeriodAnswer answer) {
        List<String> lines = new ArrayList<>();
        PeriodEstimate heights = answer.heights();
        lines.add("period               " + figures(answer));
        lines.add("of the heights       " + IntervalWords.period(heights.period(), heights.low(), heights.high())
                + (heights.halfWidth() > 0
                        ? String.format(
                                Locale.ROOT,
                                ", interval %s; %.1f periods were followed",
                                IntervalWords.interval(heights.low(), heights.high()),
                                heights.periods())
                        : ", exact: the patch is one period of a surface that repeats"));
        answer.light()
                .ifPresentOrElse(
                        light -> lines.add(String.format(
                                Locale.ROOT,
                                "of the light         %s, %s%s",
                                IntervalWords.period(light, answer.low(), answer.high()),
                                words(answer.of()),
                                answer.disagree() && heights.halfWidth() > 0
                                        ? "; the interval reaches from one to the other"
                                        : "")),
                        () -> lines.add("of the light         " + nothing(answer.of())));
        heights.describeSlips().forEach(slip -> lines.add("slips                " + slip));
        heights.second().ifPresent(second -> lines.add(second(second)));
        heights.drift()
                .filter(drift -> drift.ratio() - 1 > WORTH_SAYING)
                .ifPresent(drift -> lines.add(String.format(
                        Locale.ROOT,
                        "the period drifts    from %.1f nm at one end of the scan to %.1f nm at the other; the interval holds"
                                + " both",
                        drift.first() * NANOMETRES,
                        drift.last() * NANOMETRES)));
        return lines;
    }

    /** "900.0 nm, 95 % interval 899.9 to 900.1 nm", or the period alone where it is exact. */
    static String figures(PeriodAnswer answer) {
        if (answer.heights().halfWidth() > 0 || answer.high() - answer.low() > EXACT * answer.period()) {
            return IntervalWords.of(answer.period(), answer.low(), answer.high());
        }
        return IntervalWords.period(answer.period(), answer.period(), answer.period());
    }

    private static String nothing(PeriodAnswer.Light light) {
        return switch (light) {
            case NOT_TOLD_APART -> "not told, as its orders lie too close together";
            case DRAWN_BY_SLIPS -> "not taken, as the jump below draws it aside";
            default -> "no ridge near that, " + words(light);
        };
    }

    private static String words(PeriodAnswer.Light light) {
        return light == PeriodAnswer.Light.SCAN_ALONE
                ? "the scan alone, faded at its border"
                : "mean over all positions of the window";
    }

    private static String second(PeriodEstimate.Second second) {
        return String.format(
                Locale.ROOT,
                "a second period      %s, %.2g times as high as the first: the surface has two",
                IntervalWords.of(second.period(), second.low(), second.high()),
                second.strength());
    }

    static Map<String, Object> tree(PeriodAnswer answer, GratingTarget target) {
        Map<String, Object> tree = interval(answer.period(), answer.low(), answer.high());
        tree.put("probability", PeriodEstimator.PROBABILITY);
        PeriodEstimate heights = answer.heights();
        tree.put("of_the_heights", interval(heights.period(), heights.low(), heights.high()));
        tree.put("of_the_light_nm", answer.light().isPresent() ? answer.light().getAsDouble() * NANOMETRES : null);
        tree.put("light", answer.of().name().toLowerCase(Locale.ROOT));
        tree.put("periods_followed", heights.periods());
        target.wave()
                .ifPresent(wave -> tree.put(
                        "samples_a_period",
                        PeriodJudgement.samplesAPeriod(target.patch().scan(), wave)));
        target.direction().ifPresent(direction -> {
            tree.put("direction_degrees", Math.toDegrees(direction.radians()));
            tree.put("direction_half_width_degrees", Math.toDegrees(direction.halfWidth()));
        });
        heights.second().ifPresent(second -> {
            Map<String, Object> beside = interval(second.period(), second.low(), second.high());
            beside.put("relative_amplitude", second.strength());
            tree.put("second", beside);
        });
        heights.drift().ifPresent(drift -> {
            Map<String, Object> ends = new LinkedHashMap<>();
            ends.put("from_nm", drift.first() * NANOMETRES);
            ends.put("to_nm", drift.last() * NANOMETRES);
            tree.put("drift", ends);
        });
        tree.put(
                "slips",
                heights.slips().stream()
                        .map(slip -> Map.of("after_row", slip.row(), "periods", slip.turns()))
                        .toList());
        return tree;
    }

    private static Map<String, Object> interval(double period, double low, double high) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("nm", period * NANOMETRES);
        tree.put("low_nm", low * NANOMETRES);
        tree.put("high_nm", Double.isFinite(high) ? high * NANOMETRES : null);
        return tree;
    }
}
