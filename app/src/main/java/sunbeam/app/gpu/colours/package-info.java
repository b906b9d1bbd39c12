/** Colours at any (u, v, w), evaluated by the shaders: what tables of colours are made of. */
package sunbeam.app.gpu.colours;
