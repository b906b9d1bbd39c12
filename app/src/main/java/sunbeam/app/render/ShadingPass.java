package sunbeam.app.render;

/**
 * One run of shaders/skin.frag.
 *
 * @param stride distance of shaded pixels along rows and columns
 * @param samplesAcross samples along a pixel's side
 * @param draw index of this draw, of {@link SkinSurface#draws}
 * @param hasColors false to write footprints only
 */
record ShadingPass(int stride, int samplesAcross, int draw, boolean hasColors) {}
