/** Interpolation, quantiles and rounding to floats, which several packages share. */
package sunbeam.precompute.numerics;
