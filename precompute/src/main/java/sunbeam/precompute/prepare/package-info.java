/**
 * The few steps between what an instrument measured and the surface that light sees: crop, level, spikes, missing samples,
 * edges. Knows nothing of files.
 */
package sunbeam.precompute.prepare;
