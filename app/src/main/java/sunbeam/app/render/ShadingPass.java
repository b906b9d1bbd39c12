package sunbeam.app.render;

/**
 * One run of shaders/skin.frag.
 *
 * @param stride pixels along a side of what each lit pixel stands for
 * @param samplesAcross samples of the mesh along a side of a pixel
 * @param draw number of this draw, of {@link SkinSurface#draws}
 * @param hasColors whether colors are looked up, or footprints are found alone
 */
record ShadingPass(int stride, int samplesAcross, int draw, boolean hasColors) {}
