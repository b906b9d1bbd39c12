/** Interpolation and quantiles, which several packages share. */
package sunbeam.precompute.numerics;
