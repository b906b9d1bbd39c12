package sunbeam.app.commands.inspect;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.work.Meanwhile;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * All that is found out about a patch.
 *
 * @param patch the surface
 * @param statistics of its heights and slopes
 * @param period what it tells of its period
 * @param spectrum of its heights, as that period sees them
 * @param limit what becomes of the coherence length
 * @param drawing what a command that draws would do with it; empty where nobody asks
 */
record Inspection(
        Patch patch,
        HeightStatistics statistics,
        GratingPeriod period,
        HeightSpectrum spectrum,
        ScanLimit limit,
        Optional<DrawingPlan> drawing) {
    private static final double HALF_TURN = 180;

    /** @param planned whether a drawing is planned, too, which takes long */
    static Inspection of(Patch patch, boolean planned) {
        HeightMap map = patch.scan();
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        Meanwhile<Optional<DrawingPlan>> drawing =
                Meanwhile.start(() -> planned ? Optional.of(DrawingPlan.of(patch, limit.choices())) : Optional.empty());
        GratingPeriod period = GratingPeriod.of(patch);
        HeightSpectrum.Edges edges = period.isExact() ? HeightSpectrum.Edges.PERIODIC : HeightSpectrum.Edges.TAPERED;
        return new Inspection(
                patch, HeightStatistics.of(map), period, HeightSpectrum.of(map, edges), limit, drawing.get());
    }

    String verdict() {
        return Verdict.of(patch, period);
    }

    /** The verdict, then a name and a value per line, aligned. */
    List<String> lines() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add(verdict());
        lines.add(line(
                "size",
                String.format(
                        Locale.ROOT,
                        "%s x %s, %d x %d samples",
                        rounded(map.width()),
                        rounded(map.height()),
                        map.columns(),
                        map.rows())));
        lines.add(line(
                "heights",
                String.format(
                        Locale.ROOT,
                        "relief %s, roughness %s rms",
                        rounded(statistics.relief()),
                        rounded(statistics.rms()))));
        lines.add(line("slopes", slopes()));
        if (period.isTold()) {
            lines.add(line("period", periodWords()));
        }
        SamplingCheck.pitch(map).ifPresent(coarse -> lines.add(line("pitch", coarse)));
        return lines;
    }

    /** What stands below them for those who ask. */
    List<String> explanation() {
        List<String> lines = new ArrayList<>();
        lines.add(line("patch", patch.source()));
        patch.channels().forEach(channel -> lines.add(line("channel", channel)));
        patch.faults().forEach(fault -> lines.add(line("fault", fault.line())));
        lines.add(line("pitch", pitch()));
        lines.add(line("model", ModelError.of(patch.scan()).describe()));
        limit.line().ifPresent(said -> lines.add(line("light", said.in(OptionOrigin.INSTANCE))));
        drawing.ifPresent(plan -> lines.add(line("plan", plan.summary())));
        drawing.flatMap(DrawingPlan::plan)
                .ifPresent(plan -> lines.add(line("cost", plan.cost(patch.scan().rows()))));
        return lines;
    }

    private String periodWords() {
        double degrees = (Math.toDegrees(period.azimuth()) + HALF_TURN) % HALF_TURN;
        double halfWidth = Math.toDegrees(period.azimuthHalfWidth());
        String direction = ", in direction " + Decimals.within(degrees, halfWidth);
        String interval = period.describe();
        return period.isExact()
                ? interval + direction + " degrees: the patch repeats"
                : interval
                        + direction
                        + String.format(
                                Locale.ROOT,
                                " +- %s degrees; seen %.1f times, %.0f %% of the heights' variance",
                                Decimals.rounded(halfWidth, 2),
                                period.periods(),
                                100 * period.share());
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
