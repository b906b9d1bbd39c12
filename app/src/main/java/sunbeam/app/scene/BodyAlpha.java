package sunbeam.app.scene;

/** Opacity of the diffracted light over the body (shaders/include/blend.glsl). */
public enum BodyAlpha {
    /** Luminance of the diffracted light, relative to white. */
    LIGHT,
    /** Fresnel's reflectance, independent of the diffracted light (thesis algorithm 3.5). */
    FRESNEL
}
