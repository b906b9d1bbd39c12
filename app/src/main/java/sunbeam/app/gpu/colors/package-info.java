/** Colors at any (u, v, w), evaluated by the shaders: what tables of colors are made of. */
package sunbeam.app.gpu.colors;
