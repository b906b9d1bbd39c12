/** Numerical methods that several packages share: quadrature, interpolation, quantiles, sines of arrays. */
package sunbeam.precompute.numerics;
