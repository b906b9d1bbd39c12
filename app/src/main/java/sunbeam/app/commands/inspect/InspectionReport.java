package sunbeam.app.commands.inspect;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.HeightStatistics;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.analysis.WaveDirection;
import sunbeam.precompute.patch.HeightMap;
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
        fields.put("periods", periods());
        fields.put(
                "spectrumPeaks",
                inspection.peaks().stream().map(InspectionReport::fields).toList());
        fields.put(
                "periodIntervals",
                inspection.told().map(InspectionReport::fields).stream().toList());
        fields.put("periodNotTold", inspection.refusal().orElse(null));
        fields.put("periodLines", new PeriodLines(inspection).lines());
        fields.put("plan", inspection.drawing().plan().map(PlanReport::summary).orElse(null));
        fields.put(
                "cost",
                inspection.drawing().plan().map(plan -> plan.cost(map.rows())).orElse(null));
        fields.put("planRefused", inspection.drawing().refusal());
        fields.put("faults", patch.faults().stream().map(PatchFault::line).toList());
        fields.put("notes", patch.notes());
        fields.put("warnings", patch.warnings());
        fields.put("picture", picture.toString());
        return fields;
    }

    /** Those that are known: exactly, or with an interval; the strongest first. */
    private List<Map<String, Object>> periods() {
        if (inspection.periodicity().edges() == HeightSpectrum.Edges.PERIODIC) {
            return inspection.peaks().stream().map(InspectionReport::fields).toList();
        }
        List<Map<String, Object>> periods = new ArrayList<>();
        inspection.told().ifPresent(told -> {
            Map<String, Object> first = fields(told);
            SpectrumPeak peak = inspection.peaks().get(0);
            Optional<WaveDirection> direction = inspection.direction();
            first.put(
                    "directionDegrees",
                    Math.toDegrees(direction.map(WaveDirection::radians).orElse(peak.direction())));
            first.put(
                    "directionHalfWidthDegrees",
                    direction.map(known -> Math.toDegrees(known.halfWidth())).orElse(null));
            first.put("rmsMetres", peak.rms());
            first.put(
                    "samplesAPeriod",
                    PeriodJudgement.samplesAPeriod(inspection.patch().scan(), peak));
            periods.add(first);
            told.second().ifPresent(second -> {
                Map<String, Object> beside = interval(second.period(), second.low(), second.high());
                beside.put("directionDegrees", Math.toDegrees(peak.direction()));
                beside.put("relativeAmplitude", second.strength());
                periods.add(beside);
            });
        });
        return periods;
    }

    private static Map<String, Object> fields(SpectrumPeak peak) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("periodMetres", peak.period());
        fields.put("directionDegrees", Math.toDegrees(peak.direction()));
        fields.put("rmsMetres", peak.rms());
        return fields;
    }

    private static Map<String, Object> fields(PeriodEstimate estimate) {
        return interval(estimate.period(), estimate.low(), estimate.high());
    }

    private static Map<String, Object> interval(double period, double low, double high) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("periodMetres", period);
        fields.put("lowMetres", low);
        // JSON knows no infinity.
        fields.put("highMetres", Double.isFinite(high) ? high : null);
        fields.put("probability", PeriodEstimator.PROBABILITY);
        return fields;
    }
}
