/** Tiles of color tables on the graphics card: who makes, validates and holds them; colors of a coherent average by the shaders. */
package sunbeam.app.gpu.colors;
