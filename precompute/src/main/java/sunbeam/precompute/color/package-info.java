/** Color from spectra: observers, illuminants, quadrature over wavelengths, CIE XYZ, sRGB and tone mapping. */
package sunbeam.precompute.color;
