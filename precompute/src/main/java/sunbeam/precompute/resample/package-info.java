/**
 * Windowed spectra on a grid fine enough to be interpolated: no neighborhood of bins is left for the GPU to sum.
 */
package sunbeam.precompute.resample;
