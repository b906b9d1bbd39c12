package sunbeam.app.commands.inspect;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.work.Meanwhile;
import sunbeam.precompute.analysis.FewPeriods;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.PeriodRemedy;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.analysis.ScanHalves;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.analysis.WaveDirection;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Lengths;

/**
 * All that is found out about a patch.
 *
 * @param patch the surface
 * @param statistics of its heights and slopes
 * @param periodicity what repeats in it
 * @param spectrum that the periodicity rests on
 * @param estimates what the scan tells of each of the regularities that are told of, with the uncertainty; empty for a period of
 *     a surface, and for those along the first
 * @param few a wave that is seen too few times to be one of its periods
 * @param remedy what would show a period where none is found
 * @param limit what becomes of the coherence length
 * @param drawing what a command that draws would do with it
 */
record Inspection(
        Patch patch,
        HeightStatistics statistics,
        Periodicity periodicity,
        HeightSpectrum spectrum,
        List<Optional<PeriodEstimate>> estimates,
        Optional<FewPeriods> few,
        Optional<String> remedy,
        ScanLimit limit,
        DrawingPlan drawing) {
    /** Regularities that are told of. */
    static final int PEAKS = 6;
    // Of the period.
    private static final double SIDE = 0.05;

    static Inspection of(Patch patch) {
        HeightMap map = patch.scan();
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        // Half of the time, and much of it no work for two processors at once.
        Meanwhile<DrawingPlan> drawing = Meanwhile.start(() -> DrawingPlan.of(patch, limit.choices()));
        PeriodFinder finder = new PeriodFinder(map, patch.repetition() != Patch.Repetition.NONE);
        Periodicity periodicity = finder.all();
        return new Inspection(
                patch,
                HeightStatistics.of(map),
                periodicity,
                finder.spectrum(periodicity),
                estimates(map, finder, periodicity),
                periodicity.found() ? Optional.empty() : FewPeriods.in(map),
                periodicity.found()
                        ? Optional.empty()
                        : PeriodRemedy.in(map).map(remedy -> remedy.describe(patch, OptionOrigin.INSTANCE)),
                limit,
                drawing.get());
    }

    private static List<Optional<PeriodEstimate>> estimates(
            HeightMap map, PeriodFinder finder, Periodicity periodicity) {
        if (periodicity.edges() == HeightSpectrum.Edges.PERIODIC) {
            return List.of();
        }
        List<SpectrumPeak> peaks = strongest(periodicity);
        ScanHalves halves = new ScanHalves(map, finder.spectrum(periodicity));
        return IntStream.range(0, peaks.size())
                .parallel()
                .mapToObj(i -> i == 0 || peaks.get(i).isAcross(peaks.get(0))
                        ? PeriodEstimator.estimate(halves, peaks.get(i))
                        : Optional.<PeriodEstimate>empty())
                .toList();
    }

    /** The strongest regularities. */
    List<SpectrumPeak> peaks() {
        return strongest(periodicity);
    }

    private static List<SpectrumPeak> strongest(Periodicity periodicity) {
        List<SpectrumPeak> all = periodicity.peaks();
        return all.subList(0, Math.min(PEAKS, all.size()));
    }

    /** What the scan tells of the first of its periods, whether it is told or refused. */
    Optional<PeriodEstimate> estimate() {
        return estimates.stream().findFirst().flatMap(Function.identity());
    }

    /**
     * Why the scan does not tell the period of its strongest regularity; empty where it does. Of one that shows none: which of its
     * rows are no measurement, if that may be why.
     */
    Optional<String> refusal() {
        if (!periodicity.found()) {
            return PeriodJudgement.spoilt(patch.faults());
        }
        return periodicity.edges() == HeightSpectrum.Edges.PERIODIC
                ? Optional.empty()
                : peaks().stream()
                        .findFirst()
                        .flatMap(peak -> PeriodJudgement.refusal(patch.faults(), estimate(), peak));
    }

    /** The period that is told; empty where there is none, or it is exact. */
    Optional<PeriodEstimate> told() {
        return refusal().isPresent() ? Optional.empty() : estimate();
    }

    /** The period of another wave of a lattice, where the first is told. */
    Optional<PeriodEstimate> toldAcross(SpectrumPeak peak) {
        int number = peaks().indexOf(peak);
        return told().isEmpty() || number < 1
                ? Optional.empty()
                : estimates
                        .get(number)
                        .filter(estimate -> !isSideLine(estimate, told().get()))
                        .filter(estimate -> PeriodJudgement.refusal(patch.faults(), Optional.of(estimate), peak)
                                .isEmpty());
    }

    /** What a slip has split from the line of the wave that is told has its period and another direction. */
    private static boolean isSideLine(PeriodEstimate estimate, PeriodEstimate told) {
        return !told.slips().isEmpty() && Math.abs(estimate.period() - told.period()) < SIDE * told.period();
    }

    /** The direction of the period that is told, with its interval; empty where there is none, or the scan does not tell it. */
    Optional<WaveDirection> direction() {
        return told().flatMap(told -> WaveDirection.of(patch.scan(), peaks().get(0), told));
    }

    /** The same of another wave of a lattice. */
    Optional<WaveDirection> directionAcross(SpectrumPeak peak) {
        return toldAcross(peak).flatMap(told -> WaveDirection.of(patch.scan(), peak, told));
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
        for (int i = 0; i < patch.faults().size(); i++) {
            lines.add(line(i == 0 ? "faults" : "", patch.faults().get(i).line()));
        }
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
        int before = lines.size();
        for (String period : new PeriodLines(this).lines()) {
            lines.add(line(lines.size() == before ? "periods" : "", period));
        }
        limit.line().ifPresent(said -> lines.add(line("light", said.in(OptionOrigin.INSTANCE))));
        lines.add(line("plan", drawing.summary()));
        drawing.plan().ifPresent(plan -> lines.add(line("cost", plan.cost(map.rows()))));
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
                "%.1f degrees rms, steepest %.1f; %.1f %% of the surface steeper than %.0f degrees, where scalar theory"
                        + " fails",
                Math.toDegrees(Math.atan(statistics.rmsSlope())),
                Math.toDegrees(Math.atan(statistics.largestSlope())),
                100 * statistics.steepShare(),
                HeightStatistics.STEEP_DEGREES);
    }

    /** Four digits: more would be noise. */
    private static String rounded(double metres) {
        return Lengths.format(new BigDecimal(metres).round(new MathContext(4)).doubleValue());
    }

    private static String line(String name, String value) {
        return String.format(Locale.ROOT, "%-9s %s", name, value);
    }
}
