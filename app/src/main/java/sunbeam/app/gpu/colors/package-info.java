/** Tiles of color tables on the graphics card: requests, baking, validation and the atlas; baking of colors by shaders. */
package sunbeam.app.gpu.colors;
