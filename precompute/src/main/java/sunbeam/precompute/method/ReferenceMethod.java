package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.REPLICAS;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.CoherenceArea;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** Exact method: direct sums over the surface in double precision. */
public record ReferenceMethod(CoherenceArea area) implements Method {
    /** For this type the preset determines the window's origin only. */
    public static final MethodType TYPE = new MethodType(
            "reference",
            "exact sums in double precision on the processor; slow, not for maps.",
            Setting.union(List.of(PRESET), GaussianArea.SETTINGS, List.of(REPLICAS)),
            ReferenceMethod::of);

    private static ReferenceMethod of(Choices choices) {
        if (!choices.has(REPLICAS)) {
            return new ReferenceMethod(GaussianArea.of(choices));
        }
        if (choices.get(AVERAGE) == Average.ENSEMBLE) {
            throw choices.complaint(AVERAGE, "is not for ", REPLICAS, ", which have one position; leave out one");
        }
        if (choices.has(WINDOW_ORIGIN)) {
            throw choices.complaint(
                    WINDOW_ORIGIN, "belongs to the Gaussian window, which ", REPLICAS, " replace; leave out one");
        }
        int count = choices.get(REPLICAS, 1);
        return new ReferenceMethod(new CoherenceArea.Replicated(new Replicas(count, count)));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod referenceMethod(HeightMap map) {
        return this;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        throw new SettingException(Methods.METHOD, "evaluates single directions; use it with 'reflectance'");
    }
}
