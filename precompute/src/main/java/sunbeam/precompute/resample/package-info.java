/**
 * Windowed spectra on a grid fine enough to be interpolated: no neighbourhood of bins is left for the GPU to sum.
 */
package sunbeam.precompute.resample;
