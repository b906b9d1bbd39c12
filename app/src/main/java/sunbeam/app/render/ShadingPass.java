package sunbeam.app.render;

/**
 * Parameters of one draw with shaders/skin.frag.
 *
 * @param stride distance between shaded pixels along rows and columns, in pixels
 * @param samplesAcross number of samples along a pixel's side
 * @param draw index of this draw, below {@link SkinSurface#draws}
 * @param hasColors false to write footprints only
 */
record ShadingPass(int stride, int samplesAcross, int draw, boolean hasColors) {}
