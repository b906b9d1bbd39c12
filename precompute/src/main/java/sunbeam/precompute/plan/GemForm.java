package sunbeam.precompute.plan;

/** Form of the grating formula of method gem (shaders/method/gem.glsl). */
public enum GemForm {
    /** J. Stam's, GPU Gems, chapter 8: colors in all directions, as linear sRGB. */
    STAM,
    /** Form of the thesis's program for maps: colors as XYZ, a tenth as bright, along the grating alone, fading away from the mirror. */
    THESIS
}
