/** Small numerics that several packages share. */
package sunbeam.precompute.numerics;
