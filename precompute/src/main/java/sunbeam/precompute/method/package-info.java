/** The diffraction methods, planned for a surface: from there to what their shaders read. */
package sunbeam.precompute.method;
