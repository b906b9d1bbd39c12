package sunbeam.precompute.method;

import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Sentence;

/**
 * A diffraction method with all that a user fixes of it. Immutable; equal by value. What differs between methods is asked of the
 * method; only how scenes are sampled and moved goes by whether it is {@link TableMethod}.
 */
public interface Method {
    /** Which method. */
    MethodType type();

    /**
     * Plans it for a surface.
     *
     * @param range directions that can occur
     * @throws sunbeam.precompute.setting.SettingException when what is fixed makes no sense for the surface
     */
    MethodPlan plan(Surface surface, VisibleRange range);

    /** What it approximates, and is held against, on a surface. */
    ReferenceMethod exact(HeightMap map);

    /** What it errs by whatever the tolerance, in a few words, and what does not; nothing where the tolerance holds. */
    default Optional<Sentence> approximation() {
        return Optional.empty();
    }

    /** Whether power 1 is a flat mirror's in specular direction; else only ratios of colors mean something. */
    default boolean isOfAMirror() {
        return true;
    }
}
