package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.FRESNEL;

import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.ShaderTables;

/** How often Fresnel's reflectance counts in the radiance (shaders/include/fresnel.glsl). */
public enum FresnelFactor {
    /** Once: a mirror reflects its reflectance. */
    ONCE,
    /** Squared, as the thesis's gain has it: at 60 degrees from the half vector 1.75 times as much. */
    SQUARED;

    /** As chosen, else the preset's. */
    public static FresnelFactor of(Choices choices) {
        return choices.get(FRESNEL, Preset.isThesis(choices) ? SQUARED : ONCE);
    }

    /** The same tables for a shader with this factor. */
    public ShaderTables in(ShaderTables tables) {
        return this == ONCE
                ? tables
                : new ShaderTables.Builder(tables.shader())
                        .all(tables)
                        .define("FRESNEL_SQUARED", 1)
                        .trial(tables.trial())
                        .build(tables.windowSigma(), tables.specularReach());
    }
}
