package sunbeam.precompute.plan;

import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.setting.Choices;

/** Exponent of Fresnel's reflectance in the radiance (shaders/include/fresnel.glsl). */
public enum FresnelFactor {
    /** A mirror's radiance is proportional to its reflectance. */
    ONCE,
    SQUARED;

    public int exponent() {
        return this == SQUARED ? 2 : 1;
    }

    public static FresnelFactor of(Choices choices) {
        return choices.get(MethodSettings.FRESNEL, Preset.isThesis(choices) ? SQUARED : ONCE);
    }

    /** Throws a SettingException for the square of an index by wavelength, whose colors are no sum of two integrals. */
    public static void requireFor(RefractiveIndex index, Choices choices) {
        if (of(choices) == SQUARED && !index.isConstant()) {
            throw choices.complaint(
                    MethodSettings.FRESNEL,
                    "is for an index that is the same at all wavelengths; give once, or one number as index");
        }
    }

    public ShaderTables applyTo(ShaderTables tables) {
        return this == ONCE ? tables : tables.with(all -> all.define("FRESNEL_SQUARED", 1));
    }
}
