package sunbeam.precompute.method;

import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Sentence;

/** Diffraction method with all its settings. Immutable; equal by value. */
public interface Method {
    MethodType type();

    GaussianArea area();

    /** Plans the method for the directions that can occur; throws SettingException if a setting does not suit the surface. */
    MethodPlan plan(Surface surface, VisibleRange range);

    /** Returns the exact method that this one approximates and is compared with. */
    default ReferenceMethod referenceMethod(HeightMap map) {
        return new ReferenceMethod(area());
    }

    /** Describes the error that no tolerance bounds, with the remedy; empty if the tolerance holds. */
    default Optional<Sentence> approximation() {
        return Optional.empty();
    }

    /** Returns the exponent of Fresnel's reflectance in the radiance. */
    default FresnelFactor fresnel() {
        return FresnelFactor.ONCE;
    }

    /** True if power 1 is that of a flat mirror in specular direction; otherwise only ratios of colors are meaningful. */
    default boolean isNormalizedToMirror() {
        return true;
    }
}
