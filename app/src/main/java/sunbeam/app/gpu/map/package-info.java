/** Draws BRDF maps: colors under one light for all directions to the viewer. */
package sunbeam.app.gpu.map;
