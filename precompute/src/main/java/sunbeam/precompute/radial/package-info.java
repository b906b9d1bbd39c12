/** Colors of the ensemble average, ray by ray of (u, v): the integral over wavelengths as a convolution (docs/color-tables.md). */
package sunbeam.precompute.radial;
