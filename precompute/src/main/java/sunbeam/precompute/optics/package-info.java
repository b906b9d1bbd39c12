/** Height maps, directions, the coherence window, and the factors that turn diffracted power into radiance. */
package sunbeam.precompute.optics;
