/** Tables of colors over (u, v, w): how fine they are, where their texels lie, how they are made (docs/color-tables.md). */
package sunbeam.precompute.colortable;
