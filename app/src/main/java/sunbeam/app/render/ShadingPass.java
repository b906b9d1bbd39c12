package sunbeam.app.render;

/**
 * Parameters of one draw with shaders/skin.frag.
 *
 * @param draw index of this draw, below {@link SkinSurface#draws}; without colors that of the level, below {@link SkinSurface#levelsRead}
 * @param hasColors false to write footprints only
 */
record ShadingPass(DrawRequest request, int draw, boolean hasColors) {}
