package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.ReplicaLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** Exact method: direct sums over the surface, under a Gaussian window or, with sharp edges, over evenly lit replicas of the patch. */
public record ReferenceMethod(GaussianArea area, Optional<Replicas> replicas) implements Method {
    /** For this type the preset determines the window's origin only. */
    public static final MethodType TYPE = new MethodType(
            "reference",
            "exact sums in double precision on the processor; slow, not for maps.",
            Setting.union(List.of(MethodSettings.PRESET), GaussianArea.SETTINGS, List.of(MethodSettings.REPLICAS)),
            ReferenceMethod::of);

    public ReferenceMethod(GaussianArea area) {
        this(area, Optional.empty());
    }

    ReferenceMethod(Replicas replicas) {
        this(GaussianArea.STANDARD, Optional.of(replicas));
    }

    private static ReferenceMethod of(Choices choices) {
        if (!choices.has(MethodSettings.REPLICAS)) {
            return new ReferenceMethod(GaussianArea.of(choices));
        }
        if (choices.get(MethodSettings.AVERAGE) == Average.ENSEMBLE) {
            throw choices.complaint(
                    MethodSettings.AVERAGE,
                    "is not for ",
                    MethodSettings.REPLICAS,
                    ", which have one position; leave out one");
        }
        if (choices.has(MethodSettings.WINDOW_ORIGIN)) {
            throw choices.complaint(
                    MethodSettings.WINDOW_ORIGIN,
                    "belongs to the Gaussian window, which ",
                    MethodSettings.REPLICAS,
                    " replace; leave out one");
        }
        int count = choices.get(MethodSettings.REPLICAS, 1);
        return new ReferenceMethod(new Replicas(count, count));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod referenceMethod(HeightMap map) {
        return this;
    }

    public ExactLight light(HeightMap map, CieTable cie) {
        return replicas.<ExactLight>map(all -> new ReplicaLight(map, all, cie)).orElseGet(() -> area.over(map, cie));
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        throw new SettingException(Methods.METHOD, "evaluates single directions; use it with 'reflectance'");
    }
}
