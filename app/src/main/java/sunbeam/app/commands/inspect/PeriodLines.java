package sunbeam.app.commands.inspect;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.analysis.FewPeriods;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.IntervalWords;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.analysis.WaveDirection;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * What repeats in a surface, for people: a period together with its interval; what is only a peak of the spectrum is called
 * so, with the digits that such a peak has.
 */
final class PeriodLines {
    // Digits of a peak's place: it is some bins wide.
    private static final int ROUGH = 2;
    private static final int MOST_DIGITS = 6;
    // Of a peak's place and direction.
    private static final double NEARLY = 0.03;
    // Degrees: directions from 0 to 180.
    private static final double MIDDLE = 90;
    // Figures above say no more.
    private static final double CLEAR = 1000;

    private final Inspection inspection;

    PeriodLines(Inspection inspection) {
        this.inspection = inspection;
    }

    /** One or more. */
    List<String> lines() {
        List<String> lines = found();
        inspection.spectrum().describeBeyond().ifPresent(lines::add);
        return lines;
    }

    private List<String> found() {
        List<String> lines = new ArrayList<>();
        if (!inspection.periodicity().found() && inspection.refusal().isPresent()) {
            // Other remedies than its own would be tried on rows that are no measurement.
            return new ArrayList<>(List.of(inspection.refusal().get()));
        }
        if (!inspection.periodicity().found()) {
            inspection
                    .few()
                    .map(FewPeriods::describe)
                    .map(few -> few + "; take a larger scan")
                    .ifPresent(lines::add);
            inspection.remedy().ifPresent(remedy -> lines.add("none as the scan is, but " + remedy));
            if (lines.isEmpty()) {
                lines.add("no periodicity: " + inspection.periodicity().describeFigure());
            }
            return lines;
        }
        boolean exact = inspection.periodicity().edges() == HeightSpectrum.Edges.PERIODIC;
        for (SpectrumPeak peak : inspection.peaks()) {
            if (exact) {
                lines.add(String.format(Locale.ROOT, "%.1f nm in %s", peak.period() * 1e9, describe(peak)));
            } else if (lines.isEmpty() && inspection.told().isPresent()) {
                addTold(inspection.told().get(), peak, lines);
            } else {
                lines.add(inspection
                                .toldAcross(peak)
                                .map(across -> "and " + IntervalWords.of(across.period(), across.low(), across.high()))
                                .orElseGet(() ->
                                        "a peak of the spectrum at about " + Lengths.rounded(peak.period(), ROUGH))
                        + " in " + describe(peak, inspection.directionAcross(peak)) + differing(peak));
            }
        }
        inspection.refusal().ifPresent(refusal -> lines.add(0, refusal));
        int others =
                inspection.periodicity().peaks().size() - inspection.peaks().size();
        if (others > 0) {
            lines.add(String.format(Locale.ROOT, "and %d weaker ones", others));
        }
        return lines;
    }

    private void addTold(PeriodEstimate told, SpectrumPeak peak, List<String> lines) {
        lines.add(IntervalWords.of(told.period(), told.low(), told.high()) + ", in "
                + describe(peak, inspection.direction()));
        told.second()
                .ifPresent(second -> lines.add(String.format(
                        Locale.ROOT,
                        "and a second of %s, %.2g times as high",
                        IntervalWords.of(second.period(), second.low(), second.high()),
                        second.strength())));
        lines.addAll(told.describeSlips());
        PeriodJudgement.alias(inspection.patch().scan(), peak).ifPresent(lines::add);
        told.drift().ifPresent(ends -> lines.add("drifting from about " + apart(ends.first(), ends.last())));
    }

    /** Of the wave of a whole number of periods of the one that is told. */
    private String differing(SpectrumPeak peak) {
        SpectrumPeak first = inspection.peaks().get(0);
        double lines = peak.period() / first.period();
        double across = Math.sin(peak.direction() - first.direction());
        boolean multiple = Math.rint(lines) > 1 && Math.abs(lines - Math.rint(lines)) < NEARLY * lines;
        // Of lines at uneven distances chance makes such waves.
        boolean even = inspection
                .told()
                .filter(told -> told.halfWidth() < NEARLY * told.period())
                .isPresent();
        return even && multiple && Math.abs(across) < NEARLY
                ? String.format(
                        Locale.ROOT,
                        ": neighbouring lines differ, and the surface repeats after %.0f of them",
                        Math.rint(lines))
                : "";
    }

    /** With as many digits as it takes to tell them apart. */
    private static String apart(double first, double last) {
        int digits = 3;
        while (digits < MOST_DIGITS && Lengths.rounded(first, digits).equals(Lengths.rounded(last, digits))) {
            digits++;
        }
        return Lengths.rounded(first, digits) + " to " + Lengths.rounded(last, digits);
    }

    private String describe(SpectrumPeak peak) {
        return describe(peak, Optional.empty());
    }

    /** @param known the direction with its interval; without it, that of the peak */
    private String describe(SpectrumPeak peak, Optional<WaveDirection> known) {
        // A direction and its opposite are one: 179.96 degrees are 0.
        double degrees = Math.rint(10 * Math.toDegrees(peak.direction())) / 10 % 180;
        String direction = known.map(told -> told.describe(MIDDLE))
                .orElseGet(() -> String.format(Locale.ROOT, "%.1f degrees", degrees));
        return String.format(Locale.ROOT, "direction %s, %.1f nm rms, %s", direction, peak.rms() * 1e9, figure(peak));
    }

    private String figure(SpectrumPeak peak) {
        if (inspection.periodicity().edges() == HeightSpectrum.Edges.PERIODIC) {
            return Decimals.rounded(100 * peak.figure(), 3) + " % of the heights' variance";
        }
        return peak.figure() > CLEAR
                ? "more than 1000 times above its surroundings"
                : Decimals.rounded(peak.figure(), 2) + " times above its surroundings";
    }
}
