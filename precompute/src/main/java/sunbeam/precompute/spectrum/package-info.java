/**
 * Spectra of a patch: Fourier tables, power spectra, and their samples on grids fine enough for the GPU to interpolate, instead of summing
 * a neighborhood of bins.
 */
package sunbeam.precompute.spectrum;
