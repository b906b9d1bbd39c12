/** Spectra of a patch: Fourier tables, power spectra, and their samples on grids fine enough for the GPU to interpolate. */
package sunbeam.precompute.spectrum;
