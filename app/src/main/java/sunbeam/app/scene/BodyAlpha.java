package sunbeam.app.scene;

/** Opacity of the diffracted light over the body (shaders/include/blend.glsl). */
public enum BodyAlpha {
    /** Luminance of the diffracted light, relative to white. */
    LIGHT,
    /** Fresnel's reflectance, independent of the diffracted light, as in the thesis's program. */
    FRESNEL,
    /** The texture is added unlit where |F| / |F(0)| > 1: everywhere but in the mirror direction (thesis algorithm 3.4). */
    DRAFT
}
