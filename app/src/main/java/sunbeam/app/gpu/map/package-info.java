/** BRDF maps: one light, every direction to the viewer. */
package sunbeam.app.gpu.map;
