/**
 * Tables of colors over (u, v, w): resolution, layout, and baking, for the ensemble average by log-polar convolution along rays of (u, v)
 * (docs/color-tables.md).
 */
package sunbeam.precompute.colortable;
