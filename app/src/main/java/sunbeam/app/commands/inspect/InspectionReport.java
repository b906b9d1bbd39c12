package sunbeam.app.commands.inspect;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchFault;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.plan.PlanReport;

/**
 * An inspection for programs.
 *
 * @param inspection what was found out
 * @param picture where its picture is
 */
record InspectionReport(Inspection inspection, Path picture) {

    /** All fields by name; those with a unit say it. */
    Map<String, Object> fields() {
        Patch patch = inspection.patch();
        HeightMap map = patch.scan();
        HeightStatistics statistics = inspection.statistics();
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
        GratingPeriod period = inspection.period();
        fields.put("verdict", inspection.verdict());
        fields.put("periods", period.isTold() ? List.of(fields(period)) : List.of());
        fields.put("periodNotTold", period.refusal().orElse(null));
        Optional<PlanReport> plan = inspection.drawing().flatMap(DrawingPlan::plan);
        fields.put("plan", plan.map(PlanReport::summary).orElse(null));
        fields.put("cost", plan.map(made -> made.cost(map.rows())).orElse(null));
        fields.put("planRefused", inspection.drawing().map(DrawingPlan::refusal).orElse(""));
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
