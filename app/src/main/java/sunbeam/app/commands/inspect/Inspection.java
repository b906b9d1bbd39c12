package sunbeam.app.commands.inspect;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Lengths;

/**
 * All that is found out about a patch.
 *
 * @param patch the surface
 * @param statistics of its heights and slopes
 * @param periodicity what repeats in it
 * @param spectrum that the periodicity rests on
 * @param estimates what the scan tells of the first of its periods, with the uncertainty; empty for a period of a surface
 * @param limit what becomes of the coherence length
 * @param plan for the default tolerance and any pair of directions
 */
record Inspection(
        Patch patch,
        HeightStatistics statistics,
        Periodicity periodicity,
        HeightSpectrum spectrum,
        List<PeriodEstimate> estimates,
        ScanLimit limit,
        PlanReport plan) {
    /** Regularities that are told of. */
    static final int PEAKS = 6;

    static Inspection of(Patch patch) {
        HeightMap map = patch.scan();
        PeriodFinder finder = new PeriodFinder(map, patch.repetition() != Patch.Repetition.NONE);
        Periodicity periodicity = finder.all();
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        return new Inspection(
                patch,
                HeightStatistics.of(map),
                periodicity,
                finder.spectrum(periodicity),
                estimates(map, periodicity),
                limit,
                plan(patch, FullMethod.of(limit.choices())));
    }

    private static List<PeriodEstimate> estimates(HeightMap map, Periodicity periodicity) {
        return periodicity.edges() == HeightSpectrum.Edges.PERIODIC
                ? List.of()
                : periodicity.peaks().stream()
                        .limit(1)
                        .flatMap(peak -> PeriodEstimator.estimate(map, peak).stream())
                        .toList();
    }

    private static PlanReport plan(Patch patch, FullMethod standard) {
        return new PlanReport(standard.tablePlan(Surface.withoutIdentity(patch), VisibleRange.all()));
    }

    /** The strongest regularities. */
    List<SpectrumPeak> peaks() {
        List<SpectrumPeak> all = periodicity.peaks();
        return all.subList(0, Math.min(PEAKS, all.size()));
    }

    /** What to print: a name and a value per line, aligned. */
    List<String> lines() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add(line("patch", patch.source()));
        for (String channel : patch.channels()) {
            lines.add(line(lines.size() == 1 ? "channels" : "", channel));
        }
        lines.add(line(
                "size",
                String.format(
                        Locale.ROOT,
                        "%s x %s, %d x %d samples",
                        rounded(map.width()),
                        rounded(map.height()),
                        map.columns(),
                        map.rows())));
        lines.add(line("pitch", pitch()));
        lines.add(line(
                "heights",
                String.format(
                        Locale.ROOT,
                        "relief %s, roughness %s rms",
                        rounded(statistics.relief()),
                        rounded(statistics.rms()))));
        lines.add(line("slopes", slopes()));
        lines.add(line("model", ModelError.of(map).describe()));
        lines.addAll(periods());
        limit.line().ifPresent(said -> lines.add(line("light", said.in(OptionOrigin.INSTANCE))));
        lines.add(line("plan", plan.summary()));
        lines.add(line("cost", plan.cost(map.rows())));
        return lines;
    }

    private String pitch() {
        HeightMap map = patch.scan();
        String verdict = SamplingCheck.pitch(map)
                .orElse("fine enough for light of " + Lengths.format(SamplingCheck.SHORTEST_WAVELENGTH)
                        + ", which needs " + Lengths.format(SamplingCheck.COARSEST_PITCH));
        return String.format(Locale.ROOT, "%s x %s: %s", rounded(map.pitchX()), rounded(map.pitchY()), verdict);
    }

    private String slopes() {
        return String.format(
                Locale.ROOT,
                "%.1f degrees rms, steepest %.1f; %.2g %% of the surface steeper than %.0f degrees, where scalar theory"
                        + " fails",
                Math.toDegrees(Math.atan(statistics.rmsSlope())),
                Math.toDegrees(Math.atan(statistics.largestSlope())),
                100 * statistics.steepShare(),
                HeightStatistics.STEEP_DEGREES);
    }

    private List<String> periods() {
        if (!periodicity.found()) {
            return List.of(line("periods", "no periodicity: " + periodicity.describeFigure()));
        }
        List<String> lines = new ArrayList<>();
        for (SpectrumPeak peak : peaks()) {
            lines.add(line(lines.isEmpty() ? "periods" : "", describe(peak)));
        }
        estimates.forEach(estimate -> lines.add(line("", describe(estimate))));
        int others = periodicity.peaks().size() - peaks().size();
        if (others > 0) {
            lines.add(line("", String.format(Locale.ROOT, "and %d weaker ones", others)));
        }
        return lines;
    }

    private String describe(SpectrumPeak peak) {
        String figure = periodicity.edges() == HeightSpectrum.Edges.TAPERED
                ? String.format(Locale.ROOT, "%.3g times above its surroundings", peak.figure())
                : String.format(Locale.ROOT, "%.3g %% of the heights' variance", 100 * peak.figure());
        return String.format(
                Locale.ROOT,
                "%7.1f nm in direction %5.1f degrees, %.1f nm rms, %s",
                peak.period() * 1e9,
                Math.toDegrees(peak.direction()),
                peak.rms() * 1e9,
                figure);
    }

    private static String describe(PeriodEstimate estimate) {
        String interval = String.format(
                Locale.ROOT,
                "95 %% interval of the first: %.4g to %.4g nm",
                estimate.low() * 1e9,
                estimate.high() * 1e9);
        String second = estimate.second()
                .map(other -> ", beside a second of " + rounded(other.period()))
                .orElse("");
        String drift = estimate.drift()
                .map(ends -> String.format(
                        Locale.ROOT, ", drifting from %s to %s", rounded(ends.first()), rounded(ends.last())))
                .orElse("");
        return interval + second + drift;
    }

    /** Four digits: more would be noise. */
    private static String rounded(double metres) {
        return Lengths.format(new BigDecimal(metres).round(new MathContext(4)).doubleValue());
    }

    private static String line(String name, String value) {
        return String.format(Locale.ROOT, "%-9s %s", name, value);
    }
}
