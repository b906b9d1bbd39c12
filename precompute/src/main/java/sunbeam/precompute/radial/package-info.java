/** Radial baker: colors of the ensemble average by log-polar convolution along rays of (u, v) (docs/color-tables.md). */
package sunbeam.precompute.radial;
