/** Exact and slow reference for diffracted power: direct sums over the surface in double precision, without series or tables. */
package sunbeam.precompute.reference;
