package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.REPLICAS;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
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
            Setting.union(List.of(PRESET), GaussianArea.SETTINGS, List.of(REPLICAS)),
            ReferenceMethod::of);

    public ReferenceMethod(GaussianArea area) {
        this(area, Optional.empty());
    }

    ReferenceMethod(Replicas replicas) {
        this(GaussianArea.STANDARD, Optional.of(replicas));
    }

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

    /** Returns the exact diffracted light of a patch. */
    public ExactLight light(HeightMap map, CieTable cie) {
        return replicas.<ExactLight>map(all -> new ReplicaLight(map, all, cie)).orElseGet(() -> area.over(map, cie));
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        throw new SettingException(Methods.METHOD, "evaluates single directions; use it with 'reflectance'");
    }
}
