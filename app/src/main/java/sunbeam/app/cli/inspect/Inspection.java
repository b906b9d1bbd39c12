package sunbeam.app.cli.inspect;

import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Properties of a patch's heights, as lines for people and as fields for programs.
 *
 * @param energy energy of all orders under light along the normal, at the wavelength where it is largest
 * @param spectrum power spectrum of the heights, periodic if the period is exact, else tapered at the edges
 * @param limit coherence length that the scan's size allows
 * @param drawing plan of method full for any pair of directions; empty if it is not requested or impossible
 * @param refusal reason why there is no such plan; empty if there is one or none is requested
 */
record Inspection(
        Patch patch,
        ModelError slopes,
        EnergyBalance energy,
        GratingPeriod period,
        HeightSpectrum spectrum,
        ScanLimit limit,
        Optional<SpectrumPlan> drawing,
        String refusal) {
    private static final Direction FROM_ABOVE = new Direction(0, 0, 1);

    /** @param planned whether to make the plan of method full, which takes long */
    static Inspection of(Patch patch, boolean planned) {
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        GratingPeriod period = GratingPeriod.of(patch);
        HeightSpectrum.Edges edges = period.isExact() ? HeightSpectrum.Edges.PERIODIC : HeightSpectrum.Edges.TAPERED;
        Optional<SpectrumPlan> drawing = Optional.empty();
        String refusal = "";
        if (planned) {
            // These are the defaults of brdf-map.
            FullMethod standard = FullMethod.of(limit.choices().with(MethodSettings.AVERAGE, Average.ENSEMBLE));
            try {
                drawing = Optional.of(plan(patch, standard));
            } catch (SettingException tooMuch) {
                refusal = tooMuch.getMessage();
            }
        }
        return new Inspection(
                patch,
                ModelError.of(patch.scan()),
                EnergyBalance.largest(patch.scan(), FROM_ABOVE),
                period,
                HeightSpectrum.of(patch.scan(), edges),
                limit,
                drawing,
                refusal);
    }

    /** Plans method full; failures name the command-line options. */
    private static SpectrumPlan plan(Patch patch, FullMethod method) {
        return Choices.at(OptionOrigin.INSTANCE)
                .located(() -> method.tablePlan(Surface.withoutIdentity(patch), VisibleRange.all()));
    }

    Verdict verdict() {
        return Verdict.of(patch, period);
    }

    /** Returns the verdict, then lines of a name and its values, aligned. */
    List<String> lines() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add(verdict().sentence());
        lines.add(Text.format(
                "size      %s x %s, %d x %d samples",
                rounded(map.width()), rounded(map.height()), map.columns(), map.rows()));
        lines.add(Text.format("heights   relief %s, roughness %s rms", rounded(map.relief()), rounded(roughness())));
        lines.add(Text.format(
                "slopes    %.1f degrees rms, steepest %.1f; %.1f %% of the surface steeper than %.0f degrees, where scalar theory"
                        + " fails",
                Math.toDegrees(Math.atan(slopes.rmsSlope())),
                Math.toDegrees(Math.atan(slopes.largestSlope())),
                100 * slopes.steepShare(),
                ModelError.STEEPEST));
        energy.warning().ifPresent(words -> lines.add("energy    from above, " + words));
        if (period.isSeen()) {
            lines.add("period    " + period.describe());
        }
        SamplingCheck.pitch(map).ifPresent(coarse -> lines.add("pitch     " + coarse));
        return lines;
    }

    /** Returns the plan's summary or why there is none; empty if no plan is requested. */
    Optional<String> plan() {
        return refusal.isEmpty()
                ? drawing.map(SpectrumPlan::summary)
                : Optional.of("none; method full would refuse it for all directions at once: " + refusal);
    }

    List<String> explanation() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add("patch     " + patch.source());
        patch.channels().forEach(channel -> lines.add("channel   " + channel));
        patch.faults().forEach(fault -> lines.add("fault     " + fault.line()));
        lines.add(Text.format(
                "pitch     %s x %s: %s",
                rounded(map.pitchX()),
                rounded(map.pitchY()),
                SamplingCheck.pitch(map)
                        .orElse("fine enough for light of " + Lengths.format(SamplingCheck.SHORTEST_WAVELENGTH)
                                + ", which needs " + Lengths.format(SamplingCheck.COARSEST_PITCH))));
        lines.add("model     " + slopes.describe());
        limit.line().ifPresent(said -> lines.add("light     " + said.in(OptionOrigin.INSTANCE)));
        plan().ifPresent(summary -> lines.add("plan      " + summary));
        drawing.ifPresent(plan -> lines.add("cost      " + plan.cost(map.rows())));
        return lines;
    }

    /** Returns the root mean square of the heights about their mean (Sq of ISO 25178), meters. */
    private double roughness() {
        return Math.sqrt(StatUtils.populationVariance(patch.scan().heights()));
    }

    /** Formats a length with four digits: more would be noise of the measurement. */
    private static String rounded(double meters) {
        return Lengths.format(new BigDecimal(meters).round(new MathContext(4)).doubleValue());
    }

    /** Returns all properties by name, for JSON; names end in the unit where there is one. */
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
        fields.put("reliefMetres", map.relief());
        fields.put("roughnessMetres", roughness());
        fields.put("rmsSlope", slopes.rmsSlope());
        fields.put("largestSlope", slopes.largestSlope());
        fields.put("shareSteeperThan" + Math.round(ModelError.STEEPEST) + "Degrees", slopes.steepShare());
        fields.put("model", slopes.describe());
        fields.put("lightSentOutByMirrors", energy.ratio());
        fields.put("lightSentOutAtMetres", energy.wavelength());
        fields.put("verdict", verdict().sentence());
        fields.put("verdictCode", verdict().code().label());
        fields.put("periods", period.isSure() ? List.of(fields(period)) : List.of());
        fields.put("periodNotTold", period.isSure() ? null : period.reason());
        fields.put("aboutMetres", period.isSeen() ? period.period() : null);
        fields.put("directionsDegrees", period.isSeen() ? period.directions() : List.of());
        fields.put("plan", drawing.map(SpectrumPlan::summary).orElse(null));
        fields.put("cost", drawing.map(made -> made.cost(map.rows())).orElse(null));
        fields.put("planRefused", refusal);
        fields.put("faults", patch.faults().stream().map(ScanFault::line).toList());
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
