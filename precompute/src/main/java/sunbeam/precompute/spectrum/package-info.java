/** Spectra of a patch: expansions of exp(i k w h), Fourier transforms of their terms within bands, power spectra, and grids to interpolate. */
package sunbeam.precompute.spectrum;
