/** The exact answer: direct double-precision sums over the surface, no expansion and no table. Slow, the truth. */
package sunbeam.precompute.reference;
