/** Spectra to CIE XYZ. */
package sunbeam.precompute.color;
