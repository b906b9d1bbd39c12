/** Preparation of measured heights: crop, level, despike, fill missing samples, treat edges. Independent of file formats. */
package sunbeam.precompute.prepare;
