package sunbeam.app.render;

/**
 * Parameters of one draw with shaders/skin.frag.
 *
 * @param draw index of this draw, below {@link SkinSurface#draws}; if there are no colors, index among the levels that a footprint reads,
 *     below {@link SkinSurface#levelsRead}
 * @param hasColors false to write footprints only
 */
record ShadingPass(DrawRequest request, int draw, boolean hasColors) {}
