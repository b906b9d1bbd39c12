/** Plans of the sums and tables for a patch, a coherence window, and the directions that a scene can reach. */
package sunbeam.precompute.plan;
