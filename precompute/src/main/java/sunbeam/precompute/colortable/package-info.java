/** Tables of colors over (u, v, w): resolution, layout, and baking along rays of (u, v) (docs/color-tables.md). */
package sunbeam.precompute.colortable;
