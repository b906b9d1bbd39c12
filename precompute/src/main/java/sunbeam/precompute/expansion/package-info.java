/** Expansions of exp(i k w h) that separate what depends on direction from what depends on the surface. */
package sunbeam.precompute.expansion;
