/** Tables of colors over (u, v, w): resolution, layout and baking (docs/color-tables.md). */
package sunbeam.precompute.colortable;
