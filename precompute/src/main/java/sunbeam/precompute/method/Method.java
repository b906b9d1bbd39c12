package sunbeam.precompute.method;

import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.VisibleRange;

/**
 * A diffraction method with all that a user fixes of it. Immutable; equal by value. Nothing asks which method it has before it:
 * what differs between methods is asked of the method.
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

    /** What it errs by whatever the tolerance, in a few words; nothing where the tolerance holds. */
    default Optional<String> approximation() {
        return Optional.empty();
    }

    /** The method that does without the approximation, where it has one and there is one. */
    default Optional<MethodType> instead() {
        return Optional.empty();
    }

    /** What its colors relate to. */
    default Brightness brightness() {
        return Brightness.OF_A_MIRROR;
    }

    /** What colors relate to. */
    enum Brightness {
        /** Power 1 is a flat mirror's in specular direction. */
        OF_A_MIRROR,
        /** Nothing: only their ratios mean something. */
        UNRELATED
    }
}
