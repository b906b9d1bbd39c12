/** Diffraction methods as a user chooses them, each with its own settings, from there to plans and to the tables of their shaders. */
package sunbeam.precompute.method;
