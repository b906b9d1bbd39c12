/** Linear pictures and how they become visible: exposure, gamut, sRGB. */
package sunbeam.app.gpu.picture;
