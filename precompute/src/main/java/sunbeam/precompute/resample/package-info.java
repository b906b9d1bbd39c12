/** Windowed spectra on a grid fine enough to be interpolated: the GPU reads a few samples instead of summing a neighborhood of bins. */
package sunbeam.precompute.resample;
