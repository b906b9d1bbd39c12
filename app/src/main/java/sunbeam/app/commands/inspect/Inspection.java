package sunbeam.app.commands.inspect;

import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchFault;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Lengths;

/**
 * All that is found out about a patch, as lines for people and as fields for programs.
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

    /** @param planned whether a drawing is planned, too, which takes long */
    static Inspection of(Patch patch, boolean planned) {
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        GratingPeriod period = GratingPeriod.of(patch);
        HeightSpectrum.Edges edges = period.isExact() ? HeightSpectrum.Edges.PERIODIC : HeightSpectrum.Edges.TAPERED;
        return new Inspection(
                patch,
                HeightStatistics.of(patch.scan()),
                period,
                HeightSpectrum.of(patch.scan(), edges),
                limit,
                planned ? Optional.of(DrawingPlan.of(patch, limit.choices())) : Optional.empty());
    }

    String verdict() {
        return Verdict.of(patch, period);
    }

    /** The verdict, then a name and a value per line, aligned. */
    List<String> lines() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add(verdict());
        lines.add(String.format(
                Locale.ROOT,
                "size      %s x %s, %d x %d samples",
                rounded(map.width()),
                rounded(map.height()),
                map.columns(),
                map.rows()));
        lines.add(String.format(
                Locale.ROOT,
                "heights   relief %s, roughness %s rms",
                rounded(statistics.relief()),
                rounded(statistics.rms())));
        lines.add(String.format(
                Locale.ROOT,
                "slopes    %.1f degrees rms, steepest %.1f; %.1f %% of the surface steeper than %.0f degrees, where scalar theory"
                        + " fails",
                Math.toDegrees(Math.atan(statistics.rmsSlope())),
                Math.toDegrees(Math.atan(statistics.largestSlope())),
                100 * statistics.steepShare(),
                HeightStatistics.STEEP_DEGREES));
        if (period.isTold()) {
            lines.add("period    " + period.describe());
        }
        SamplingCheck.pitch(map).ifPresent(coarse -> lines.add("pitch     " + coarse));
        return lines;
    }

    /** What stands below them for those who ask. */
    List<String> explanation() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add("patch     " + patch.source());
        patch.channels().forEach(channel -> lines.add("channel   " + channel));
        patch.faults().forEach(fault -> lines.add("fault     " + fault.line()));
        lines.add(String.format(
                Locale.ROOT,
                "pitch     %s x %s: %s",
                rounded(map.pitchX()),
                rounded(map.pitchY()),
                SamplingCheck.pitch(map)
                        .orElse("fine enough for light of " + Lengths.format(SamplingCheck.SHORTEST_WAVELENGTH)
                                + ", which needs " + Lengths.format(SamplingCheck.COARSEST_PITCH))));
        lines.add("model     " + ModelError.of(map).describe());
        limit.line().ifPresent(said -> lines.add("light     " + said.in(OptionOrigin.INSTANCE)));
        drawing.ifPresent(plan -> lines.add("plan      " + plan.summary()));
        drawing.flatMap(DrawingPlan::plan).ifPresent(plan -> lines.add("cost      " + plan.cost(map.rows())));
        return lines;
    }

    /** Four digits: more would be noise. */
    private static String rounded(double metres) {
        return Lengths.format(new BigDecimal(metres).round(new MathContext(4)).doubleValue());
    }

    /**
     * All by name; what has a unit says it.
     *
     * @param picture where it is
     */
    Map<String, Object> fields(Path picture) {
        HeightMap map = patch.scan();
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("name", patch.name());
        fields.put("source", patch.source());
        fields.put("channels", patch.channels());
        fields.put("columns", map.columns());
        fields.put("rows", map.rows());
        fields.put("widthMetres", map.width());
        fields.put("heightMetres", map.height());
        fields.put("samplingIsFineEnough", SamplingCheck.pitch(map).isEmpty());
        fields.put("reliefMetres", statistics.relief());
        fields.put("roughnessMetres", statistics.rms());
        fields.put("rmsSlope", statistics.rmsSlope());
        fields.put("largestSlope", statistics.largestSlope());
        fields.put(
                "shareSteeperThan" + Math.round(HeightStatistics.STEEP_DEGREES) + "Degrees", statistics.steepShare());
        fields.put("model", ModelError.of(map).describe());
        fields.put("verdict", verdict());
        fields.put("periods", period.isTold() ? List.of(fields(period)) : List.of());
        fields.put("periodNotTold", period.refusal().orElse(null));
        Optional<PlanReport> plan = drawing.flatMap(DrawingPlan::plan);
        fields.put("plan", plan.map(PlanReport::summary).orElse(null));
        fields.put("cost", plan.map(made -> made.cost(map.rows())).orElse(null));
        fields.put("planRefused", drawing.map(DrawingPlan::refusal).orElse(""));
        fields.put("faults", patch.faults().stream().map(PatchFault::line).toList());
        fields.put("notes", patch.notes());
        fields.put("warnings", patch.warnings());
        fields.put("picture", picture.toString());
        return fields;
    }

    private static Map<String, Object> fields(GratingPeriod period) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("periodMetres", period.period());
        fields.put("lowMetres", period.low());
        fields.put("highMetres", period.high());
        fields.put("probability", GratingPeriod.PROBABILITY);
        fields.put("directionDegrees", Math.toDegrees(period.azimuth()));
        fields.put("directionHalfWidthDegrees", Math.toDegrees(period.azimuthHalfWidth()));
        // JSON knows no infinity.
        fields.put("periodsInTheScan", period.isExact() ? null : period.periods());
        fields.put("shareOfVariance", period.share());
        return fields;
    }
}
