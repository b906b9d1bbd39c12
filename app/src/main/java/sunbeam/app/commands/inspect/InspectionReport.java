package sunbeam.app.commands.inspect;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.SamplingCheck;

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
        fields.put(
                "periods",
                inspection.peaks().stream().map(InspectionReport::fields).toList());
        fields.put(
                "periodIntervals",
                inspection.estimates().stream().map(InspectionReport::fields).toList());
        fields.put("plan", inspection.plan().summary());
        fields.put("cost", inspection.plan().cost(map.rows()));
        fields.put("notes", patch.notes());
        fields.put("warnings", patch.warnings());
        fields.put("picture", picture.toString());
        return fields;
    }

    private static Map<String, Object> fields(SpectrumPeak peak) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("periodMetres", peak.period());
        fields.put("directionDegrees", Math.toDegrees(peak.direction()));
        fields.put("rmsMetres", peak.rms());
        return fields;
    }

    private static Map<String, Object> fields(PeriodEstimate estimate) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("periodMetres", estimate.period());
        fields.put("lowMetres", estimate.low());
        fields.put("highMetres", estimate.high());
        fields.put("probability", 0.95);
        return fields;
    }
}
