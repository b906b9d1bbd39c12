package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.FRESNEL;

import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.ShaderTables;

/** Exponent of Fresnel's reflectance in the radiance (shaders/include/fresnel.glsl). */
public enum FresnelFactor {
    /** A mirror's radiance is proportional to its reflectance. */
    ONCE,
    SQUARED;

    /** Returns the chosen factor, by default the preset's. */
    public static FresnelFactor of(Choices choices) {
        return choices.get(FRESNEL, Preset.isThesis(choices) ? SQUARED : ONCE);
    }

    /** Returns the tables for a shader with this factor. */
    public ShaderTables applyTo(ShaderTables tables) {
        return this == ONCE ? tables : tables.with(all -> all.define("FRESNEL_SQUARED", 1));
    }
}
