/** Plans: what is computed for a patch, a window and the directions that a scene can reach. */
package sunbeam.precompute.plan;
