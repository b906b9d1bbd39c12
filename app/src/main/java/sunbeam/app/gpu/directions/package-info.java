/** Lists of directions, evaluated by the shaders. */
package sunbeam.app.gpu.directions;
