/**
 * The diffraction methods as a user chooses them, each with its own settings and no others; planned for a surface, and from
 * there to what their shaders read.
 */
package sunbeam.precompute.method;
