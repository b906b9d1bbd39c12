/** Faults of measured heights, and their preparation: crop, level, despike, fill missing samples, treat edges. Independent of file formats. */
package sunbeam.precompute.prepare;
