/** Exact reference: direct double-precision sums over the surface, without expansion or table. Slow. */
package sunbeam.precompute.reference;
