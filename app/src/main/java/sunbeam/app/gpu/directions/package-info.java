/** Evaluates lists of directions by the shaders. */
package sunbeam.app.gpu.directions;
