package sunbeam.app.scene;

/** What hides the body below diffracted light (shaders/include/blend.glsl). */
public enum BodyAlpha {
    /** The diffracted light itself, as far as it is as bright as white. */
    LIGHT,
    /** Fresnel's reflectance, however little is diffracted, and ambient light takes its share of the rest: the thesis's algorithm 3.5. */
    FRESNEL
}
