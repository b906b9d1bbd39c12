package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.Plausibility;
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
 * @param thetaI angle of the light to the normal that the verdict is for, degrees
 * @param energy energy of all orders under light along the normal, where it is largest; empty for a deep relief
 * @param drawing plan of method full for any pair of directions; empty if it is not requested or, with a refusal, impossible
 */
record Inspection(
        Patch patch,
        double thetaI,
        ModelError slopes,
        Optional<EnergyBalance> energy,
        GratingPeriod period,
        HeightSpectrum spectrum,
        ScanLimit limit,
        Optional<SpectrumPlan> drawing,
        String refusal) {
    // Digits of lengths: more would be noise of the measurement.
    private static final int DIGITS = 4;
    private static final Direction FROM_ABOVE = new Direction(0, 0, 1);

    /**
     * @param period the patch's
     * @param withPlan whether to make the plan of method full, which takes long
     */
    static Inspection of(Patch patch, GratingPeriod period, double thetaI, boolean withPlan) {
        ScanLimit limit = ScanLimit.of(Choices.none(), patch);
        HeightSpectrum.Edges edges = period.isExact() ? HeightSpectrum.Edges.PERIODIC : HeightSpectrum.Edges.TAPERED;
        Optional<SpectrumPlan> drawing = Optional.empty();
        String refusal = "";
        if (withPlan) {
            // These are the defaults of brdf-map.
            FullMethod standard = FullMethod.of(limit.choices().with(MethodSettings.AVERAGE, Average.ENSEMBLE));
            try {
                drawing = Optional.of(Choices.at(OptionOrigin.INSTANCE)
                        .located(() -> standard.tablePlan(Surface.of(patch), VisibleRange.all())));
            } catch (SettingException tooMuch) {
                refusal = tooMuch.getMessage();
            }
        }
        return new Inspection(
                patch,
                thetaI,
                patch.slopes(),
                EnergyBalance.largest(patch.scan(), RefractiveIndex.KERATIN, FROM_ABOVE),
                period,
                HeightSpectrum.of(patch.scan(), edges),
                limit,
                drawing,
                refusal);
    }

    Verdict verdict() {
        return Verdict.of(patch, period, thetaI, 0);
    }

    private static String length(double meters) {
        return Lengths.rounded(meters, DIGITS);
    }

    List<String> lines() {
        HeightMap map = patch.scan();
        List<String> lines = new ArrayList<>();
        lines.add(verdict().sentence());
        lines.add("size      " + length(map.width()) + " x " + length(map.height()) + ", " + map.columns() + " x "
                + map.rows() + " samples");
        lines.add("heights   relief " + length(patch.measured().relief()) + ", roughness " + length(roughness())
                + " rms");
        patch.gaps().ifPresent(gaps -> lines.add("gaps      " + gaps));
        lines.add(Text.format(
                "slopes    %.1f degrees rms, steepest %.1f; %.1f %% of the surface steeper than %.0f degrees, where scalar theory"
                        + " fails",
                Math.toDegrees(Math.atan(slopes.rmsSlope())),
                Math.toDegrees(Math.atan(slopes.largestSlope())),
                100 * slopes.steepShare(),
                ModelError.STEEPEST));
        energy.flatMap(EnergyBalance::warning).ifPresent(words -> lines.add("energy    from above, " + words));
        if (period.isSeen()) {
            lines.add("period    " + period.describe());
        }
        period.caution(patch).ifPresent(note -> lines.add("note      " + note));
        Plausibility.pitch(map).ifPresent(coarse -> lines.add("pitch     " + coarse));
        return lines;
    }

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
        String fine = "fine enough for light of " + Lengths.format(CieTable.MINIMUM_WAVELENGTH) + ", which needs "
                + Lengths.format(Plausibility.COARSEST_PITCH);
        lines.add("pitch     " + length(map.pitchX()) + " x " + length(map.pitchY()) + ": "
                + Plausibility.pitch(map).orElse(fine));
        lines.add("model     " + slopes.describe());
        limit.line().ifPresent(said -> lines.add("light     " + said.in(OptionOrigin.INSTANCE)));
        plan().ifPresent(summary -> lines.add("plan      " + summary));
        drawing.ifPresent(plan -> lines.add("cost      " + plan.cost(map.rows())));
        return lines;
    }

    /** Returns the root mean square of the heights about their mean (Sq of ISO 25178), meters. */
    private double roughness() {
        return Math.sqrt(StatUtils.populationVariance(patch.measuredHeights()));
    }

    Map<String, Object> fields() {
        HeightMap map = patch.scan();
        Map<String, Object> fields = JsonOption.fields(patch, period, verdict());
        fields.put("theta_i_deg", thetaI);
        fields.put("channels", patch.channels());
        fields.put("columns", map.columns());
        fields.put("rows", map.rows());
        fields.put("width_m", map.width());
        fields.put("height_m", map.height());
        fields.put("sampling_is_fine_enough", Plausibility.pitch(map).isEmpty());
        fields.put("relief_m", patch.measured().relief());
        fields.put("roughness_m", roughness());
        fields.put("rms_slope", slopes.rmsSlope());
        fields.put("largest_slope", slopes.largestSlope());
        fields.put("share_steeper_than_" + Math.round(ModelError.STEEPEST) + "_deg", slopes.steepShare());
        fields.put("model", slopes.describe());
        fields.put(
                "light_sent_out_from_above_by_mirrors",
                energy.map(EnergyBalance::ratio).orElse(null));
        fields.put("light_sent_out_at_m", energy.map(EnergyBalance::wavelength).orElse(null));
        fields.put("plan", drawing.map(SpectrumPlan::summary).orElse(null));
        fields.put("cost", drawing.map(made -> made.cost(map.rows())).orElse(null));
        fields.put("plan_refused", refusal);
        return fields;
    }
}
